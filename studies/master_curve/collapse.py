"""Shift curves of friction over speed onto one: the rule, and how well it does.

A curve is log10 mu over log10 v. Every curve is shifted onto one reference curve, by s along log v
and, where that is asked for, by t along log mu. s is tried at every value of ``SHIFTS``; t is then
the mean difference; chosen is the s of the least rms difference from the reference, which is
interpolated between its points (monotone cubics, Fritsch and Carlson 1980,
doi:10.1137/0717021). Only points within the reference's range of speeds count, and of every
curve at least ``OVERLAP`` of its points must; the others are left out and counted. No point is
chosen by hand.
"""

from typing import NamedTuple

import numpy as np
from scipy.interpolate import PchipInterpolator

SHIFTS = np.arange(-500, 501) * 0.01  # decades of speed
OVERLAP = 2.0 / 3.0
LEAST_POINTS = 4


class Curve(NamedTuple):
    """Friction over speed with its standard error; all of shape (points,), speeds ascending."""

    x: np.ndarray  # log10 of the speed
    y: np.ndarray  # log10 of the coefficient of friction
    error: np.ndarray  # standard error of y


class Shift(NamedTuple):
    """How one curve comes onto the reference."""

    along_speed: float  # s, decades, added to x
    along_friction: float  # t, decades, added to y
    speed_error: float  # standard error of s, from the scatter about the reference
    squares: float  # sum of squares of the differences that remain, decades squared
    points: int  # that lie within the range of the reference
    left_out: int


class Collapse(NamedTuple):
    """All curves of a set on one reference."""

    shifts: tuple[Shift, ...]

    @property
    def rms(self) -> float:
        """Root of the mean square of what remains over all points that count, in decades."""
        points = sum(shift.points for shift in self.shifts)
        squares = sum(shift.squares for shift in self.shifts)
        return float(np.sqrt(squares / points)) if points else float("nan")

    @property
    def left_out(self) -> int:
        """Points that lie beyond the reference once they are shifted."""
        return sum(shift.left_out for shift in self.shifts)


UNSHIFTED, ALONG_SPEED, ALONG_BOTH = "unshifted", "along speed", "along both"


def collapse(curves: list[Curve], reference: Curve, how: str) -> Collapse:
    """Return how all curves come onto the reference. how : UNSHIFTED, ALONG_SPEED, ALONG_BOTH."""
    tried = np.zeros(1) if how == UNSHIFTED else SHIFTS
    return Collapse(tuple(best(curve, reference, tried, how == ALONG_BOTH) for curve in curves))


def best(curve: Curve, reference: Curve, tried: np.ndarray, vertically: bool) -> Shift:
    """Return the shift, out of those that are tried along speed, of the least rms difference."""
    law = PchipInterpolator(reference.x, reference.y, extrapolate=False)
    moved = curve.x + tried[:, None]
    gap = law(moved) - curve.y  # NaN beyond the reference
    points = np.isfinite(gap).sum(axis=1)
    enough = points >= max(LEAST_POINTS, OVERLAP * curve.x.size)
    if not enough.any():
        nan = float("nan")
        return Shift(nan, nan, nan, 0.0, 0, curve.x.size)
    share = np.maximum(points, 1)
    lift = np.nansum(gap, axis=1) / share if vertically else np.zeros(tried.size)
    squares = np.nansum((gap - lift[:, None]) ** 2, axis=1)
    k = int(np.argmin(np.where(enough, squares / share, np.inf)))
    error = float("nan")
    if tried.size > 1:
        error = _error(law(moved[k], 1), squares[k], int(points[k]), vertically)
    n = int(points[k])
    return Shift(float(tried[k]), float(lift[k]), error, float(squares[k]), n, curve.x.size - n)


def _error(slope: np.ndarray, squares: float, points: int, vertically: bool) -> float:
    """Return the standard error of a shift along speed by least squares, linearised."""
    known = slope[np.isfinite(slope)]
    spread = known - known.mean() if vertically else known
    freedom = points - 1 - vertically
    if freedom < 1 or not np.any(spread):
        return float("nan")
    return float(np.sqrt(squares / freedom / np.sum(spread**2)))
