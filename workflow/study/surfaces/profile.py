"""Measured lines as a study uses them: levelled, periodic, and all sampled alike."""

import hashlib
from typing import NamedTuple

import numpy as np

from ....kernels import measured_amplitudes, rms_slope
from ...ground import UserError
from .alike import Alike, alike
from .as_read import KEY, LEAST_SAMPLES, Asked, plain
from .files import read_lines

SLOPES = 1e-5, 30.0  # of lines with heights and lengths in one unit
LOADS = 1e-8, 1e6  # F_N/(4 G L h)
quietly = np.errstate(all="ignore")  # heights of 1e200 m, lengths of 1e-320 m: the slope refuses


class Profile(NamedTuple):
    """Prepared lines of one measurement, in m; row i is the line of realization i."""

    heights: np.ndarray  # shape (lines, n), read only; one element per sample
    length: float  # m, of the period: n steps
    measured_length: float  # m, of a line as it was measured: half the period if mirrored
    notes: str  # where the lines come from and what was done to them
    digest: str  # of the heights: what a stored result depends on
    alike: Alike | None = None  # what neighbouring lines have in common; None: independent

    @property
    def spacing(self) -> float:
        """Return the distance of samples, and of elements (m)."""
        return self.length / self.heights.shape[-1]

    @property
    def amplitudes(self) -> np.ndarray:
        """Return the rms amplitudes of the modes over all lines (m), shape (n/2,)."""
        return measured_amplitudes(self.heights)

    @property
    def roughness(self) -> float:
        """Return the rms height over all lines, each about its own mean (m)."""
        return float(np.sqrt(np.mean(np.var(self.heights, axis=1))))

    @property
    def slope(self) -> float:
        """Return the spectral rms slope over all lines."""
        return float(np.divide(rms_slope(self.amplitudes, self.heights.shape[1]), self.spacing))


@quietly
def read_profile(asked: Asked, detrend: str, periodic: str) -> Profile:
    """Return the prepared lines of a file. Raises UserError, one line that names key and file."""
    lines = read_lines(asked)
    levelled = level(lines.heights, detrend)
    what = f"{KEY} = {asked.name!r}"
    check_not_flat(what, levelled, lines.heights)
    copies = PERIODICS[periodic]
    length = copies * lines.step * lines.heights.shape[1]
    notes = f"{lines.notes}; {_told(detrend, periodic)}"
    if found := spikes(levelled):
        notes += f"; {found} samples stand out as spikes, kept"
    profile = _profile(make_periodic(levelled, periodic), length, copies, notes)
    check_slope(
        what,
        f"check surface.units{f'; {found} samples stand out as spikes' * bool(found)}",
        profile,
    )
    said = f"; h = {profile.roughness:.4g} m, rms slope {profile.slope:.4g}"
    return profile._replace(notes=profile.notes + said, alike=alike(levelled))


@quietly
def given_profile(heights: object, length: float) -> Profile:
    """Return the profile of heights given in m, shape (n,) or (lines, n), one period each.

    length : of the period (m), n steps; one element per sample. Raises UserError that names the
    argument, ``profile``.
    """
    lines = given_heights(heights)
    if lines.ndim != 2 or not lines.size or lines.shape[1] < LEAST_SAMPLES:
        raise UserError(
            f"profile: has the shape {lines.shape}: must hold at least {LEAST_SAMPLES} "
            "heights, or lines of them"
        )
    check_finite(heights, lines, "line")
    check_not_flat("profile", lines, lines)
    notes = f"given from Python: {len(lines)} of {lines.shape[1]} samples, one period as it is"
    profile = _profile(lines, length, 1, notes)
    check_slope("profile", "give heights and length both in m", profile)
    return profile._replace(alike=alike(level(lines, "mean")))


def given_heights(heights: object) -> np.ndarray:
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
    digest = hashlib.sha256(f"{own.shape}".encode() + own.tobytes()).hexdigest()
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
    """Raise UserError for a line that is a plateau, heights without any roughness."""
    flat = heights.std(axis=1) <= FLAT * np.abs(raw).max(axis=1)
    if flat.any():
        raise UserError(
            f"{what}: line {int(np.argmax(flat)) + 1} of {flat.size} is flat: needs "
            "heights that differ by more than a trend"
        )
