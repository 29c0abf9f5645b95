"""Prepared measured lines, and maps for a half-space: levelled and periodic."""

import hashlib
from typing import NamedTuple

import numpy as np

from ....kernels import measured_amplitudes, rms_slope
from ....kernels.half_space.surface import map_amplitudes, rms_slope_of
from ...ground import UserError
from .line_correlation import LineCorrelation, line_correlation
from .positions import STEP_TOLERANCE
from .raw_lines import MAX_MAP_ASPECT, MIN_SAMPLES, LineFile, Lines, plain

SLOPE_LIMITS = 1e-5, 30.0  # of the rms slope; beyond them heights and lengths differ in unit
LOAD_LIMITS = 1e-8, 1e6  # F_N/(4 G L h)
quietly = np.errstate(all="ignore")  # extreme heights and lengths: check_slope refuses them


class Profile(NamedTuple):
    """Prepared lines, or maps, of one measurement, in m; row i is the line of realization i."""

    # Read only, one element per sample: shape (lines, n); for a half-space (maps, n, n), or
    # (maps, 1, n) for line contacts.
    heights: np.ndarray
    length: float  # m, of the period: n steps
    measured_length: float  # m, of a measured line: half the period if mirrored
    notes: str  # source and preparation of the lines
    digest: str  # of the heights; part of the identity of a stored result
    correlation: LineCorrelation | None = None  # of neighbouring lines; None: independent

    @property
    def spacing(self) -> float:
        """Return the distance of samples, and of elements (m)."""
        return self.length / self.heights.shape[-1]

    @property
    def amplitudes(self) -> np.ndarray:
        """Return the rms amplitude of each mode over all lines (m), shape (n/2,).

        For maps, they are the amplitudes of rings of wave vectors.
        """
        if self.heights.ndim == 2:
            return measured_amplitudes(self.heights)
        return np.sqrt(np.mean([map_amplitudes(grid) ** 2 for grid in self.heights], axis=0))

    @property
    def roughness(self) -> float:
        """Return the rms height over all lines, about the mean of each line (m)."""
        return float(np.sqrt(np.mean(np.var(self.heights, axis=_line_axes(self.heights)))))

    @property
    def skewness(self) -> float:
        """Return the skewness of the heights, about the mean of each line."""
        centred = self.heights - self.heights.mean(axis=_line_axes(self.heights), keepdims=True)
        return float(np.mean(centred**3) / np.mean(centred**2) ** 1.5)

    @property
    def slope(self) -> float:
        """Return the spectral rms slope over all lines; for maps that of the full gradient."""
        rms = rms_slope if self.heights.ndim == 2 else rms_slope_of
        return float(np.divide(rms(self.amplitudes, self.heights.shape[-1]), self.spacing))


def _line_axes(heights: np.ndarray) -> tuple[int, ...]:
    """Return the axes of a line, or of a map."""
    return tuple(range(1, heights.ndim))


def is_map(lines: Lines, loaded_by_force: bool = False) -> bool:
    """Return whether the lines are rows of a map, whose distance is stated.

    Under a normal force the rows of a strip are lines, which the force presses one by one.
    """
    low, high = sorted(lines.heights.shape)
    strip = loaded_by_force and high > MAX_MAP_ASPECT * low
    return len(lines.heights) >= MIN_SAMPLES and lines.row_spacing is not None and not strip


@quietly
def profile_of_lines(file: LineFile, lines: Lines, detrend: str, periodic: str) -> Profile:
    """Return the prepared lines of a file. Raises UserError, one line that names key and file."""
    levelled = level(lines.heights, detrend)
    check_not_flat(file.prefix, levelled, lines.heights)
    read = f"{file.name}: {lines.size}, {lines.notes}"
    notes, hint = f"{read}; {_preparation_text(detrend, periodic)}", ""
    if spike_count := spikes(levelled):
        hint = f"; {spike_count} samples stand out as spikes"
        notes += f"{hint}, kept"
    whole = make_periodic(levelled, periodic)
    return _measured_profile(file, whole, lines.step, periodic, notes, hint)._replace(
        correlation=line_correlation(levelled)
    )


@quietly
def map_of_lines(file: LineFile, lines: Lines, detrend: str, periodic: str) -> Profile:
    """Return the prepared map of a file: the largest square at its centre. Raises UserError.

    The row spacing must equal the sample spacing. This is assumed if the file does not state it.
    """
    if file.gaps == "drop":
        raise UserError('surface.gaps = "drop": leaves rows out of a map; use "fill"')
    rows, samples = lines.heights.shape
    if rows < MIN_SAMPLES:
        raise file.refused(
            f"{rows} rows of {samples} samples are not a map, which a half-space needs; use "
            'scene.body = "foundation", or scene.run with a line contact'
        )
    if lines.row_spacing is not None and abs(lines.row_spacing / lines.step - 1.0) > STEP_TOLERANCE:
        raise file.refused(
            f"its rows are {lines.row_spacing:.4g} m apart and samples {lines.step:.4g} m: a "
            'half-space needs a map of square cells; resample it, or set scene.body = "foundation"'
        )
    square = central_square(lines.heights)
    side = len(square)
    levelled = _level_map(square, detrend)
    check_not_flat(file.prefix, levelled[None], square[None])
    assumed = " (row distance assumed equal)" if lines.row_spacing is None else ""
    cut = "" if rows == samples else f", the middle of {rows} x {samples}"
    whole = make_periodic(make_periodic(levelled, periodic).T, periodic).T
    notes = (
        f"{file.name}: map of {side} x {side}{cut}, pitch {lines.step:.4g} m{assumed}, "
        f"{lines.notes}; {_map_preparation_text(detrend, periodic, len(whole))}"
    )
    return _measured_profile(file, whole[None], lines.step, periodic, notes)


def central_square(heights: np.ndarray) -> np.ndarray:
    """Return the largest square at the centre of a map."""
    side = min(heights.shape)
    top, left = ((size - side) // 2 for size in heights.shape)
    return heights[top : top + side, left : left + side]


def _measured_profile(
    file: LineFile, heights: np.ndarray, step: float, periodic: str, notes: str, hint: str = ""
) -> Profile:
    """Return the profile of one period of heights, with its rms height and slope in the notes."""
    length = step * heights.shape[-1]
    profile = _read_only_profile(heights, length, PERIODICS[periodic], notes)
    check_slope(file.prefix, f"check surface.units{hint}", profile)
    statistics = f"; h = {profile.roughness:.4g} m, rms slope {profile.slope:.4g}"
    return profile._replace(notes=profile.notes + statistics)


@quietly
def profile_of_array(heights: object, length: float, as_map: bool = False) -> Profile:
    """Return the profile of one period of heights in m: lines of shape (n,) or (lines, n).

    as_map : whether they are a map (rows, n), whose rows are as far apart as samples and whose
    central square is used, or a line contact (n,) of a half-space. length : of n steps (m); one
    element per sample. Raises UserError that names the argument ``profile``.
    """
    try:
        values = np.atleast_2d(plain(heights))  # NaN if masked
    except (OverflowError, TypeError, ValueError):
        raise UserError("profile: must be an array of heights in m") from None
    square = as_map and len(values) > 1
    if values.ndim != 2 or min(values.shape[not square :]) < MIN_SAMPLES or not values.size:
        needs = f"at least {MIN_SAMPLES} heights, or lines of them"
        if as_map:
            needs = f"a map (rows, n), or a line contact (n,), of {MIN_SAMPLES} samples each way"
        raise UserError(f"profile: has the shape {values.shape}: must hold {needs}")
    used = central_square(values) if square else values
    notes = f"{len(values)} of {values.shape[1]} samples"
    if as_map:
        cut = "" if used.shape == values.shape else f", the middle {len(used)} x {len(used)}"
        notes = f"a {'map' if square else 'line contact'} of {values.shape}{cut}"
    _check_finite(heights, used, "row" if as_map else "line")
    period = used[None] if as_map else used
    check_not_flat("profile", period, period)
    notes = f"given from Python: {notes}, one period as it is"
    profile = _read_only_profile(period, length * used.shape[1] / values.shape[1], 1, notes)
    check_slope("profile", "give heights and length both in m", profile)
    if as_map:
        return profile
    return profile._replace(correlation=line_correlation(level(used, "mean")))


def rows_of_map(profile: Profile) -> Profile:
    """Return the rows of a map as lines of the same period."""
    rows = profile.heights.reshape(-1, profile.heights.shape[-1])
    lines = _read_only_profile(rows, profile.length, 1, f"rows of {profile.notes}")
    correlation = line_correlation(level(rows, "mean"))
    return lines._replace(measured_length=profile.measured_length, correlation=correlation)


def _check_finite(given: object, heights: np.ndarray, row_name: str) -> None:
    """Raise UserError for heights, shape (rows, n), that are masked in ``given`` or not finite."""
    if not np.isfinite(heights).all():
        row, sample = np.argwhere(~np.isfinite(heights))[0]
        masked = int(np.ma.count_masked(given))
        masked_text = f", {masked} of {heights.size} are masked" if masked else ""
        raise UserError(
            f"profile: sample {sample + 1} of {row_name} {row + 1} is {heights[row, sample]}: all "
            f"must be finite{masked_text}; fill gaps in first"
        )


def check_load(profile: Profile, load: np.ndarray) -> None:
    """Raise UserError for loads F_N/(4 G L h) that indicate wrong units of force or modulus.

    L is the measured length.
    """
    low, high = float(np.min(load)), float(np.max(load))
    if not (LOAD_LIMITS[0] <= low and high <= LOAD_LIMITS[1]):
        raise UserError(
            f"grid.normal_force: F_N/(4 G L h) runs from {low:.3g} to {high:.3g} on L = "
            f"{profile.measured_length:.3g} m with h = {profile.roughness:.3g} m, but must lie "
            f"between {LOAD_LIMITS[0]:g} and {LOAD_LIMITS[1]:g}: give the force in N and "
            "the modulus in Pa"
        )


def check_slope(prefix: str, hint: str, profile: Profile) -> None:
    """Raise UserError for a slope that indicates different units of heights and length."""
    if not SLOPE_LIMITS[0] <= profile.slope <= SLOPE_LIMITS[1]:
        raise UserError(
            f"{prefix}: the rms slope of the heights is {profile.slope:.3g}, but must lie between "
            f"{SLOPE_LIMITS[0]:g} and {SLOPE_LIMITS[1]:g}: {hint}"
        )


def _preparation_text(detrend: str, periodic: str) -> str:
    """Return the preparation of lines in words."""
    removed = "nothing" if detrend == "none" else f"its {detrend}"
    made = {
        "none": "taken as one period",
        "mirror": "mirrored: the period is the line followed by its reverse and carries twice "
        "normal_force",
        "taper": f"brought to its mean by a cosine over {TAPER_SHARE:.0%} of its length at each "
        "end",
    }
    return f"{removed} removed from each line, which is {made[periodic]}"


def _map_preparation_text(detrend: str, periodic: str, side: int) -> str:
    """Return the preparation of a map with ``side`` samples a side in words."""
    removed = {"none": "nothing", "line": "tilt"}.get(detrend, detrend)
    made = {
        "none": "taken as one period",
        "mirror": f"mirrored to {side} x {side}",
        "taper": f"brought to its mean over {TAPER_SHARE:.0%} of each side",
    }
    return f"{removed} removed, {made[periodic]}"


def _read_only_profile(heights: np.ndarray, length: float, copies: int, notes: str) -> Profile:
    values = np.array(heights, dtype=float, order="C")
    values.setflags(write=False)
    kind = "" if values.ndim == 2 else "map "
    digest = hashlib.sha256(f"{kind}{values.shape}".encode() + values.tobytes()).hexdigest()
    return Profile(values, length, length / copies, notes, digest)


DETRENDS = {"none": -1, "mean": 0, "line": 1, "parabola": 2}  # degree of the removed polynomial
PERIODICS = {"none": 1, "mirror": 2, "taper": 1}  # measured lengths in one period
TAPER_SHARE = 0.1  # of the length, at either end
FLAT_TOLERANCE = 1e-9  # of the largest height: rounding in a levelled straight line


def level(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Subtract the polynomial fitted to each line from heights of shape (lines, n)."""
    t = np.linspace(-1.0, 1.0, heights.shape[1])
    orthogonal = np.ones_like(t), t, t**2 - np.mean(t**2)
    for polynomial in orthogonal[: DETRENDS[detrend] + 1]:
        part = np.sum(heights * polynomial, axis=1) / np.sum(polynomial**2)
        heights = heights - part[:, None] * polynomial
    return heights


def _level_map(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Subtract the fitted polynomial in x and y from a map: mean, plane or parabola."""
    degree = DETRENDS[detrend]
    if degree < 0:
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
    """Return one period of each line, shape (lines, n), or (lines, 2 n) if mirrored.

    ``mirror`` appends the line reversed. ``taper`` brings both ends to the mean height by a
    cosine over a tenth of the length. ``none`` leaves a step if the ends differ.
    """
    if periodic == "mirror":
        return np.concatenate([heights, heights[:, ::-1]], axis=1)
    if periodic == "taper":
        samples = heights.shape[1]
        from_end = np.minimum(np.arange(samples), np.arange(samples)[::-1]) + 0.5
        window = np.sin(0.5 * np.pi * np.minimum(1.0, from_end / (TAPER_SHARE * samples))) ** 2
        mean = heights.mean(axis=1, keepdims=True)
        return mean + window * (heights - mean)
    return heights


def spikes(heights: np.ndarray) -> int:
    """Return the number of samples that deviate from their neighbours by over 10 sigma.

    The deviation is that from the mean of both neighbours. Sigma is estimated from the median
    deviation of a line; lines with a median of zero are not examined.
    """
    curvature = heights[:, 1:-1] - 0.5 * (heights[:, :-2] + heights[:, 2:])
    usual = np.median(np.abs(curvature), axis=1, keepdims=True) / 0.6745  # sigma, if normal
    return int(np.count_nonzero((usual > 0.0) & (np.abs(curvature) > 10.0 * usual)))


def check_not_flat(prefix: str, heights: np.ndarray, raw: np.ndarray) -> None:
    """Raise UserError for a line, or a map, without roughness."""
    axes = _line_axes(heights)
    flat = heights.std(axis=axes) <= FLAT_TOLERANCE * np.abs(raw).max(axis=axes)
    if flat.any():
        line = f"line {int(np.argmax(flat)) + 1} of {flat.size} " if heights.ndim == 2 else ""
        raise UserError(f"{prefix}: {line}is flat: needs heights that differ by more than a trend")
