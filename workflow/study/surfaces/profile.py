"""Measured lines, and maps of a half-space: levelled, periodic, and all sampled alike."""

import hashlib
from typing import NamedTuple

import numpy as np

from ....kernels import measured_amplitudes, rms_slope
from ....kernels.half_space.surface import map_amplitudes, rms_slope_of
from ...ground import UserError
from .files import read_lines
from .line_correlation import LineCorrelation, line_correlation
from .positions import UNEVEN
from .raw_lines import KEY, MIN_SAMPLES, LineFile, plain

SLOPES = 1e-5, 30.0  # of lines with heights and lengths in one unit
LOADS = 1e-8, 1e6  # F_N/(4 G L h)
quietly = np.errstate(all="ignore")  # heights of 1e200 m, lengths of 1e-320 m: the slope refuses


class Profile(NamedTuple):
    """Prepared lines, or maps, of one measurement, in m; row i is the line of realization i."""

    # Read only, one element per sample: shape (lines, n), of a half-space (maps, n, n), or
    # (maps, 1, n) of line contacts.
    heights: np.ndarray
    length: float  # m, of the period: n steps
    measured_length: float  # m, of a line as it was measured: half the period if mirrored
    notes: str  # where the lines come from and what was done to them
    digest: str  # of the heights: what a stored result depends on
    correlation: LineCorrelation | None = None  # of neighbouring lines; None: independent

    @property
    def spacing(self) -> float:
        """Return the distance of samples, and of elements (m)."""
        return self.length / self.heights.shape[-1]

    @property
    def amplitudes(self) -> np.ndarray:
        """Return the rms amplitudes of the modes over all lines (m), shape (n/2,); of a map |h_q|.

        Those of a map are as of a ring.
        """
        if self.heights.ndim == 2:
            return measured_amplitudes(self.heights)
        return np.sqrt(np.mean([map_amplitudes(own) ** 2 for own in self.heights], axis=0))

    @property
    def roughness(self) -> float:
        """Return the rms height over all lines, each about its own mean (m)."""
        return float(np.sqrt(np.mean(np.var(self.heights, axis=_of_each(self.heights)))))

    @property
    def slope(self) -> float:
        """Return the spectral rms slope over all lines; of maps that of the full gradient."""
        rms = rms_slope if self.heights.ndim == 2 else rms_slope_of
        return float(np.divide(rms(self.amplitudes, self.heights.shape[-1]), self.spacing))


def _of_each(heights: np.ndarray) -> tuple[int, ...]:
    """Return the axes of one line, or of one map."""
    return tuple(range(1, heights.ndim))


@quietly
def read_profile(asked: LineFile, detrend: str, periodic: str) -> Profile:
    """Return the prepared lines of a file. Raises UserError, one line that names key and file."""
    lines = read_lines(asked)
    levelled = level(lines.heights, detrend)
    check_not_flat(f"{KEY} = {asked.name!r}", levelled, lines.heights)
    notes, hint = f"{lines.notes}; {_told(detrend, periodic)}", ""
    if found := spikes(levelled):
        hint = f"; {found} samples stand out as spikes"
        notes += f"{hint}, kept"
    whole = make_periodic(levelled, periodic)
    return _measured(asked, whole, lines.step, periodic, notes, hint)._replace(
        correlation=line_correlation(levelled)
    )


@quietly
def read_map(asked: LineFile, detrend: str, periodic: str) -> Profile:
    """Return the prepared map of a file, the largest square in its middle. Raises UserError.

    Its rows must be as far apart as the samples of a row, and are where the file does not say.
    """
    what = f"{KEY} = {asked.name!r}"
    if asked.gaps == "drop":
        raise UserError('surface.gaps = "drop": leaves rows out of a map; use "fill"')
    lines = read_lines(asked)
    rows, samples = lines.heights.shape
    if rows < MIN_SAMPLES:
        raise UserError(
            f"{what}: {rows} rows of {samples} samples are no map, which a half-space needs; use "
            'scene.body = "foundation", or scene.run with a line contact'
        )
    if lines.row_spacing is not None and abs(lines.row_spacing / lines.step - 1.0) > UNEVEN:
        raise UserError(
            f"{what}: its rows are {lines.row_spacing:.4g} m apart and samples "
            f"{lines.step:.4g} m: a half-space needs a map of square cells"
        )
    side = min(rows, samples)
    top, left = (rows - side) // 2, (samples - side) // 2
    square = lines.heights[top : top + side, left : left + side]
    levelled = _level_map(square, detrend)
    check_not_flat(what, levelled[None], square[None])
    assumed = " (assumed)" if lines.row_spacing is None else ""
    cut = "" if rows == samples else f"; the middle {side} x {side} of {rows} x {samples}"
    notes = (
        f"{lines.notes}; a map, rows as far apart as samples{assumed}{cut}; {detrend} removed, "
        f"{periodic}"
    )
    whole = make_periodic(make_periodic(levelled, periodic).T, periodic).T
    return _measured(asked, whole[None], lines.step, periodic, notes)


def _measured(
    asked: LineFile, heights: np.ndarray, step: float, periodic: str, notes: str, hint: str = ""
) -> Profile:
    """Return the profile of heights that are one period, with what they are like in its notes."""
    length = step * heights.shape[-1]
    profile = _profile(heights, length, PERIODICS[periodic], notes)
    check_slope(f"{KEY} = {asked.name!r}", f"check surface.units{hint}", profile)
    said = f"; h = {profile.roughness:.4g} m, rms slope {profile.slope:.4g}"
    return profile._replace(notes=profile.notes + said)


@quietly
def profile_of_array(heights: object, length: float) -> Profile:
    """Return the profile of heights given in m, shape (n,) or (lines, n), one period each.

    length : of the period (m), n steps; one element per sample. Raises UserError that names the
    argument, ``profile``.
    """
    lines = heights_of_array(heights)
    if lines.ndim != 2 or not lines.size or lines.shape[1] < MIN_SAMPLES:
        raise UserError(
            f"profile: has the shape {lines.shape}: must hold at least {MIN_SAMPLES} "
            "heights, or lines of them"
        )
    notes = f"given from Python: {len(lines)} of {lines.shape[1]} samples, one period as it is"
    profile = _given(heights, lines, length, notes)
    return profile._replace(correlation=line_correlation(level(lines, "mean")))


@quietly
def map_of_array(heights: object, length: float) -> Profile:
    """Return the map of heights given in m, shape (n, n), or (n,) of a line contact; one period.

    length : of the side (m), n steps; one element per sample. Raises UserError that names the
    argument, ``profile``.
    """
    own = heights_of_array(heights)
    if own.ndim != 2 or own.shape[0] not in (1, own.shape[1]) or own.shape[1] < MIN_SAMPLES:
        raise UserError(
            f"profile: has the shape {own.shape}: a half-space takes a square map (n, n), "
            f"the last axis along x, or a line contact (n,), of {MIN_SAMPLES} samples or more"
        )
    what = "line contact" if own.shape[0] == 1 else "map"
    notes = f"given from Python: a {what} of {own.shape}, one period as it is"
    return _given(heights, own[None], length, notes)


def _given(heights: object, own: np.ndarray, length: float, notes: str) -> Profile:
    """Return the profile of lines, or of one map, as they are once they are checked."""
    check_finite(heights, own.reshape(-1, own.shape[-1]), "line" if own.ndim == 2 else "row")
    check_not_flat("profile", own, own)
    profile = _profile(own, length, 1, notes)
    check_slope("profile", "give heights and length both in m", profile)
    return profile


def heights_of_array(heights: object) -> np.ndarray:
    """Return heights that are given from Python, NaN where they are masked, in two dimensions.

    One dimension becomes one row; more than two stay. Raises UserError for what is no array.
    """
    try:
        return np.atleast_2d(plain(heights))
    except (OverflowError, TypeError, ValueError):
        raise UserError("profile: must be an array of heights in m") from None


def check_finite(given: object, heights: np.ndarray, row_name: str) -> None:
    """Raise UserError for heights, shape (rows, n), that are not finite, or masked as given."""
    if not np.isfinite(heights).all():
        row, sample = np.argwhere(~np.isfinite(heights))[0]
        masked = int(np.ma.count_masked(given))
        gone = f", {masked} of {heights.size} are masked" if masked else ""
        raise UserError(
            f"profile: sample {sample + 1} of {row_name} {row + 1} is {heights[row, sample]}: all "
            f"must be finite{gone}; fill gaps in first"
        )


def check_load(key: str, profile: Profile, load: np.ndarray) -> None:
    """Raise UserError for loads F_N/(4 G L h) that no force in N on lines in m makes.

    L : the measured length. key : of the force, for the message.
    """
    low, high = float(np.min(load)), float(np.max(load))
    if not (LOADS[0] <= low and high <= LOADS[1]):
        raise UserError(
            f"{key}: F_N/(4 G L h) runs from {low:.3g} to {high:.3g} on L = "
            f"{profile.measured_length:.3g} m with h = {profile.roughness:.3g} m, but must lie "
            f"between {LOADS[0]:g} and {LOADS[1]:g}: give the force in N, the modulus in Pa"
        )


def check_slope(what: str, hint: str, profile: Profile) -> None:
    """Raise UserError for a slope that no surface in one unit has."""
    if not SLOPES[0] <= profile.slope <= SLOPES[1]:
        raise UserError(
            f"{what}: the rms slope of the heights is {profile.slope:.3g}, but must lie between "
            f"{SLOPES[0]:g} and {SLOPES[1]:g}: {hint}"
        )


def _told(detrend: str, periodic: str) -> str:
    """Return in words what was done to lines."""
    removed = "nothing" if detrend == "none" else f"its {detrend}"
    made = {
        "none": "taken as one period, whether its ends meet or not",
        "mirror": "mirrored: the period is the line and then the line reversed, and normal_force "
        "presses on either half",
        "taper": f"brought to its mean by a cosine over {TAPERED:.0%} of its length at either end",
    }
    return f"{removed} removed from each line, which is {made[periodic]}"


def _profile(heights: np.ndarray, length: float, copies: int, notes: str) -> Profile:
    own = np.array(heights, dtype=float, order="C")
    own.setflags(write=False)
    kind = "" if own.ndim == 2 else "map "
    digest = hashlib.sha256(f"{kind}{own.shape}".encode() + own.tobytes()).hexdigest()
    return Profile(own, length, length / copies, notes, digest)


DETRENDS = {"none": None, "mean": 0, "line": 1, "parabola": 2}  # degree of what is removed
PERIODICS = {"none": 1, "mirror": 2, "taper": 1}  # how often a line goes into the period
TAPERED = 0.1  # of the length, at either end
FLAT = 1e-9  # of the largest height: what levelling leaves of a straight line by rounding


def level(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Return the heights, shape (lines, n), less the polynomial fitted to each line."""
    degree = DETRENDS[detrend]
    if degree is None:
        return heights
    t = np.linspace(-1.0, 1.0, heights.shape[1])
    for polynomial in (np.ones_like(t), t, t**2 - np.mean(t**2))[: degree + 1]:  # orthogonal
        part = np.sum(heights * polynomial, axis=1) / np.sum(polynomial**2)
        heights = heights - part[:, None] * polynomial
    return heights


def _level_map(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Return a map less the polynomial in x and y that is fitted to it: mean, plane, parabola."""
    degree = DETRENDS[detrend]
    if degree is None:
        return heights
    t = np.linspace(-1.0, 1.0, len(heights))
    terms = [
        (t[:, None] ** i * t[None, :] ** j).ravel()
        for i in range(degree + 1)
        for j in range(degree + 1 - i)
    ]
    basis = np.stack(terms, axis=1)
    fitted = np.linalg.lstsq(basis, heights.ravel(), rcond=None)[0]
    return heights - (basis @ fitted).reshape(heights.shape)


def make_periodic(heights: np.ndarray, periodic: str) -> np.ndarray:
    """Return one period of each line, shape (lines, n), or (lines, 2 n) where it is mirrored.

    ``mirror`` appends the line reversed. ``taper`` brings both ends to the mean height by a
    cosine over a tenth of the length. ``none`` leaves a step where the ends do not meet.
    """
    if periodic == "mirror":
        return np.concatenate([heights, heights[:, ::-1]], axis=1)
    if periodic == "taper":
        samples = heights.shape[1]
        from_end = np.minimum(np.arange(samples), np.arange(samples)[::-1]) + 0.5
        window = np.sin(0.5 * np.pi * np.minimum(1.0, from_end / (TAPERED * samples))) ** 2
        mean = heights.mean(axis=1, keepdims=True)
        return mean + window * (heights - mean)
    return heights


def spikes(heights: np.ndarray) -> int:
    """Return how many samples stand out from both neighbours by over 10 usual differences.

    The usual difference is the median, over the line, of a sample's distance from the mean of its
    neighbours; where that is zero, nothing can be said.
    """
    curvature = heights[:, 1:-1] - 0.5 * (heights[:, :-2] + heights[:, 2:])
    usual = np.median(np.abs(curvature), axis=1, keepdims=True) / 0.6745  # sigma, if normal
    return int(np.count_nonzero((usual > 0.0) & (np.abs(curvature) > 10.0 * usual)))


def check_not_flat(what: str, heights: np.ndarray, raw: np.ndarray) -> None:
    """Raise UserError for a line, or a whole map, that is a plateau, without any roughness."""
    axes = _of_each(heights)
    flat = heights.std(axis=axes) <= FLAT * np.abs(raw).max(axis=axes)
    if flat.any():
        line = f"line {int(np.argmax(flat)) + 1} of {flat.size} " if heights.ndim == 2 else ""
        raise UserError(f"{what}: {line}is flat: needs heights that differ by more than a trend")
