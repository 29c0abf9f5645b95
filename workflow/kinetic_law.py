"""The kinetic law of elastomer friction, eqs. 12 to 16, for use in other models.

It requires only numpy. After a velocity change, friction first jumps (eq. 12), then relaxes to
the steady value (eqs. 6, 13):

    law = KineticLaw(relaxation_time=1e-3, hurst=0.7, q_max=1.6e6, rms_slope=0.02,
                     velocity=v_table, friction=mu_table)
    mu = law.after_jump(0.1, 0.12, time)     # step from 0.1 to 0.12 m/s at time 0
    mu = law.response(time, velocity)        # any v(t): stick-slip, control, rest and reversal

Two details follow the model rather than the printed equations. Eq. 12 holds for a small step; a
large step is the sum of small ones, so that the result does not depend on their number. The rate
of eq. 13 is evaluated at the velocity after the step.

Source: Li, Dimaki, Popov, Psakhie, Popov (2014), doi:10.1038/srep05795, p. 3 to 4. In the printed
eqs. 10 to 15, dz means the rms slope grad z.
"""

import warnings
from collections.abc import Mapping
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from .given_motion import LawError, finely, finite_numbers, given_motion

PLATEAU = 0.4  # eq. 11
LARGEST_SHARE_OF_LOAD = 0.2  # limit of eta v h/F_N; above it too few peaks touch
FLAT = 1e-6  # smaller changes of a logarithm count as zero
PIECE = 0.02  # relative velocity change of one step, within which the rate is constant


def normalised_jump(mu_bar: ArrayLike) -> np.ndarray:
    """Return the jump (dmu_0/grad z)/(dv/v1) of a small step for mu_bar = mu_1/grad z (eq. 12)."""
    return (1.0 / np.asarray(mu_bar) ** 2 + 1.0 / PLATEAU**2) ** -0.5


def jump_between(
    mu_1: ArrayLike, mu_2: ArrayLike, log_ratio: ArrayLike, rms_slope: ArrayLike
) -> np.ndarray:
    """Return the jump between two velocities: the sum of the jumps of small steps (eq. 12).

    mu_1, mu_2 : positive steady friction at v1 and v2; a power law of velocity in between.
    log_ratio : ln(v2/v1). rms_slope : grad z. All broadcast. With P = 0.4 grad z, the sum is
    int (1/mu^2 + 1/P^2)^(-1/2) dv/v = ln(v2/v1) P (asinh(mu_2/P) - asinh(mu_1/P))/ln(mu_2/mu_1).
    It is mu_2 - mu_1 in region I, and P ln(v2/v1) on the plateau.
    """
    mu_1, mu_2 = np.asarray(mu_1, dtype=float), np.asarray(mu_2, dtype=float)
    limit = PLATEAU * np.asarray(rms_slope, dtype=float)
    change = np.log(mu_2 / mu_1)
    flat = np.abs(change) < FLAT
    rise = np.arcsinh(mu_2 / limit) - np.arcsinh(mu_1 / limit)
    mean = limit * rise / np.where(flat, 1.0, change)
    small = (1.0 / (mu_1 * mu_2) + 1.0 / limit**2) ** -0.5
    return np.where(flat, small, mean) * log_ratio


def relaxation_rate(x: ArrayLike, hurst: float, time_below_one: bool = False) -> np.ndarray:
    """Return the rate b = x^alpha in 1/tau (eq. 13), with x = v2 tau q_max after the step.

    alpha is 1 for x < 1 and 1 - H above. With ``time_below_one``, b = 1 for x < 1, as in the model
    if it is converged in time (docs/model.md, "Where the program departs from the paper").
    """
    x = np.asarray(x, dtype=float)
    return x ** np.where(x < 1.0, 0.0 if time_below_one else 1.0, 1.0 - hurst)


class BeyondKineticLawWarning(UserWarning):
    """The kinetic law is evaluated outside its range, or where friction is not known."""


class KineticLaw:
    """Friction mu(t) after velocity changes, from tau, H, q_max, grad z and steady friction mu(v).

    Velocities may be zero or negative; friction is an odd function of velocity. After steps of -20
    and 30 % to speeds v with eta v h < 0.2 F_N, the law deviates from simulations by 13 % of the
    total change of friction in the median, and by 37 % at most (docs/verification.md).
    """

    def __init__(
        self,
        *,
        relaxation_time: float,
        hurst: float,
        q_max: float,
        rms_slope: float,
        velocity: ArrayLike,
        friction: ArrayLike,
        time_below_one: bool = False,
        fastest: float | None = None,
    ) -> None:
        """Store tau (s), H, q_max (1/m), grad z and a table of steady friction over velocity (m/s).

        Friction is a power law of velocity between the points of the table, proportional to
        velocity below the table, and constant above it. fastest : the highest speed (m/s) at which
        the law holds, if known; higher speeds cause a warning. time_below_one : use b = 1 for
        x < 1. Raises UserError for invalid values.
        """
        self.velocity = finite_numbers("velocity", velocity)
        self.friction = finite_numbers("friction", friction)
        names = ("relaxation_time", "q_max", "rms_slope", "hurst")
        given = (relaxation_time, q_max, rms_slope, hurst)
        *positive, exponent = map(finite_numbers, names, given)
        if self.velocity.ndim != 1 or self.velocity.shape != self.friction.shape:
            raise LawError("velocity and friction must be one-dimensional and of one length")
        if self.velocity.size < 2 or (np.diff(self.velocity) <= 0).any() or self.velocity[0] <= 0:
            raise LawError("velocity must hold two or more increasing positive values")
        if not (self.friction > 0.0).all():
            raise LawError("friction must be positive")
        in_range = exponent.ndim == 0 and 0.0 <= exponent <= 1.0
        if not in_range or any(value.ndim or value <= 0.0 for value in positive):
            raise LawError("relaxation_time, q_max, rms_slope must be positive, hurst in [0, 1]")
        if fastest is not None and not fastest > 0.0:
            raise LawError("fastest must be positive")
        self.relaxation_time = relaxation_time
        self.hurst = hurst
        self.q_max = q_max
        self.rms_slope = rms_slope
        self.time_below_one = time_below_one
        self.fastest = fastest
        log_ratios = np.diff(np.log(self.velocity))
        rises = jump_between(self.friction[:-1], self.friction[1:], log_ratios, rms_slope)
        limit = PLATEAU * rms_slope
        first = limit * np.arcsinh(self.friction[0] / limit)
        self._sums = first + np.concatenate([[0.0], np.cumsum(rises)])

    @classmethod
    def from_result(
        cls,
        dataset: Any,
        point: Mapping[str, Any] | None = None,
        time_below_one: bool = True,
    ) -> Self:
        """Return the law for the result of a study with several velocities, an xarray.Dataset.

        point : values on the other axes of the grid, such as {"hurst": 0.7, "normal_force": 1.0};
        the nearest grid values are used. Axes of one value, and velocity_step, may be omitted.
        time_below_one : use b = 1 for x < 1, as in converged results. Raises UserError if
        ``point`` omits another axis, if friction is unknown, or if there are fewer than two
        velocities.
        """
        try:
            chosen = dataset[["mu_1", "rms_slope", "tau", "q_max", "shear_modulus"]]
            for axis, value in (point or {}).items():
                chosen = chosen.sel({axis: value}, method="nearest")
        except (AttributeError, LookupError, TypeError, ValueError) as error:
            raise LawError(f"the dataset, or the point in it, is none: {error}") from error
        if "velocity_step" in chosen.dims:  # does not affect steady friction at v1
            chosen = chosen.isel(velocity_step=0)
        chosen = chosen.squeeze()
        open_axes = [str(axis) for axis in chosen.dims if axis != "velocity"]
        if open_axes:
            raise LawError(f"point must say where along {', '.join(open_axes)}")
        if "velocity" not in chosen.dims:
            raise LawError("velocity must hold two or more increasing positive values")
        chosen = chosen.sortby("velocity")
        viscosity = float(chosen["shear_modulus"]) * float(chosen["tau"])
        fastest = float(chosen["normal_force"]) / (viscosity * float(chosen["roughness"]))
        return cls(
            relaxation_time=float(chosen["tau"]),
            hurst=float(chosen["hurst"]),
            q_max=float(chosen["q_max"]),
            rms_slope=float(np.ravel(chosen["rms_slope"])[0]),
            velocity=chosen["velocity"].values,
            friction=chosen["mu_1"].values,
            time_below_one=time_below_one,
            fastest=LARGEST_SHARE_OF_LOAD * fastest,
        )

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return the steady friction mu(v); v in m/s, any shape and sign."""
        v = np.asarray(v, dtype=float)
        speed = np.abs(v)
        table = np.log(self.velocity), np.log(self.friction)
        inside = np.exp(np.interp(np.log(np.maximum(speed, self.velocity[0])), *table))
        return np.sign(v) * inside * np.minimum(speed / self.velocity[0], 1.0)

    def jump(self, v1: ArrayLike, v2: ArrayLike) -> np.ndarray:
        """Return the instantaneous change of mu from v1 to v2 (eq. 12, summed over small steps)."""
        return self._jumps_from_rest(v2) - self._jumps_from_rest(v1)

    def relaxation_times(self, v: ArrayLike) -> np.ndarray:
        """Return the relaxation time tau/b (s) at velocity v; for v tau q_max > 1 it is eq. 16.

        At rest it is infinite, or tau with ``time_below_one``.
        """
        x = np.abs(np.asarray(v, dtype=float)) * self.relaxation_time * self.q_max
        with np.errstate(divide="ignore"):
            return self.relaxation_time / relaxation_rate(x, self.hurst, self.time_below_one)

    def relaxation_length(self, v: ArrayLike) -> np.ndarray:
        """Return the distance D_c (m) slid in a relaxation time; where b = x < 1, it is 1/q_max."""
        return np.abs(v) * self.relaxation_times(v)

    def after_jump(self, v1: float, v2: float, time: ArrayLike) -> np.ndarray:
        """Return mu(t) for a velocity jump from v1 to v2 at t = 0; mu(v1) for t < 0, time in s.

        Eqs. 14 and 15, with mu(v2) in place of its linearisation mu(v1) + mu'(v1) dv (eq. 8), and
        with the relaxation rate at v2. Warns where the law does not hold.
        """
        self._warn(np.array([v1, v2]))
        time = np.asarray(time, dtype=float)
        mu_1, mu_2 = self.steady(v1), self.steady(v2)
        amplitude = mu_1 + self.jump(v1, v2) - mu_2
        decay = np.exp(-np.maximum(time, 0.0) / self.relaxation_times(v2))
        return np.where(time < 0.0, mu_1, mu_2 + amplitude * decay)

    def response(self, time: ArrayLike, velocity: ArrayLike) -> np.ndarray:
        """Return mu at sampled times (s) for sampled velocities (m/s), both of shape (n,).

        v(t) is linear between samples; two samples at one time are a step. Sliding is steady before
        the first sample. Velocity changes are divided into small steps, each with the relaxation
        rate at its own velocity, so that the result does not depend on the sampling of v(t). Warns
        where the law does not hold. Raises UserError for decreasing times or non-finite values.
        """
        time, velocity = given_motion(time, velocity)
        if not time.size:
            return np.zeros(0)
        self._warn(velocity)
        least = min(self.velocity[0], 1.0 / (self.relaxation_time * self.q_max))
        t, v, last = finely(time, velocity, least, PIECE)
        over = self._jumps_from_rest(v) - self.steady(v)  # excess after an instantaneous change
        decay = np.diff(t) / self.relaxation_times(0.5 * (v[1:] + v[:-1]))
        keep = np.exp(-decay)
        fresh = np.diff(over) * np.where(decay > FLAT, (1.0 - keep) / np.maximum(decay, FLAT), 1.0)
        excess = np.zeros_like(v)
        for k in range(keep.size):
            excess[k + 1] = excess[k] * keep[k] + fresh[k]
        return self.steady(velocity) + excess[last]

    def _jumps_from_rest(self, v: ArrayLike) -> np.ndarray:
        """Return the sum of small jumps (eq. 12) from rest to v; its differences are jumps."""
        v = np.asarray(v, dtype=float)
        speed, mu = np.abs(v), np.abs(self.steady(v))
        limit = PLATEAU * self.rms_slope
        k = np.clip(np.searchsorted(self.velocity, speed, "right") - 1, 0, None)
        log_ratio = np.log(np.maximum(speed, self.velocity[0]) / self.velocity[k])
        upper = np.where(speed < self.velocity[0], self.friction[0], mu)
        above = self._sums[k] + jump_between(self.friction[k], upper, log_ratio, self.rms_slope)
        return np.sign(v) * np.where(
            speed < self.velocity[0], limit * np.arcsinh(mu / limit), above
        )

    def _warn(self, v: np.ndarray) -> None:
        """Warn if a speed lies above the table, or above the range of eqs. 12 to 16."""
        fastest = float(np.max(np.abs(v)))
        if fastest > self.velocity[-1] * (1.0 + FLAT):
            message = f"{fastest:g} m/s is above the table of steady friction, which ends at "
            message += f"{self.velocity[-1]:g} m/s; friction is taken as constant there"
            warnings.warn(message, BeyondKineticLawWarning, stacklevel=3)
        if self.fastest is not None and fastest > self.fastest * (1.0 + FLAT):
            message = (
                f"{fastest:g} m/s is above {self.fastest:.3g} m/s, up to which the kinetic law "
            )
            message += "holds: so few peaks touch that it errs by as much as friction changes"
            warnings.warn(message, BeyondKineticLawWarning, stacklevel=3)
