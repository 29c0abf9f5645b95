"""The kinetic law of elastomer friction, eqs. 12 to 16, for other people's models.

Needs numpy alone. Friction first follows a velocity change by a jump (eq. 12), then relaxes to
the steady value (eqs. 6, 13):

    law = KineticLaw(relaxation_time=1e-3, hurst=0.7, q_max=1.6e6, rms_slope=0.02,
                     velocity=v_table, friction=mu_table)
    mu = law.after_jump(0.1, 0.12, time)     # step from 0.1 to 0.12 m/s at time 0
    mu = law.response(time, velocity)        # any sampled v(t): stick-slip, control

Source: Li, Dimaki, Popov, Psakhie, Popov (2014), doi:10.1038/srep05795, p. 3 to 4. Where the
printed eqs. 10 to 15 have dz, read the rms slope grad z.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

PLATEAU = 0.4  # eq. 11


def normalised_jump(mu_bar: ArrayLike) -> np.ndarray:
    """Return the jump (dmu_0/grad z)/(dv/v1) for mu_bar = mu_1/grad z (eq. 12)."""
    return (1.0 / np.asarray(mu_bar) ** 2 + 1.0 / PLATEAU**2) ** -0.5


def exponent(x: ArrayLike, hurst: float, time_below_one: bool = False) -> np.ndarray:
    """Return alpha of b = x^alpha (eq. 13): 1 for x < 1 and 1 - H above.

    ``time_below_one`` replaces the branch x < 1 by b = 1, which is what the model gives when it
    is converged in time (README, "Where results depart from the paper").
    """
    return np.where(np.asarray(x) < 1.0, 0.0 if time_below_one else 1.0, 1.0 - hurst)


def relaxation_rate(x: ArrayLike, hurst: float, time_below_one: bool = False) -> np.ndarray:
    """Return b = x^alpha (eq. 13); see ``exponent``."""
    return np.asarray(x, dtype=float) ** exponent(x, hurst, time_below_one)


class KineticLaw:
    """mu(t) after velocity changes, from tau, H, q_max, grad z and the steady friction mu(v)."""

    def __init__(
        self,
        *,
        relaxation_time: float,
        hurst: float,
        q_max: float,
        rms_slope: float,
        velocity: Sequence[float],
        friction: Sequence[float],
        time_below_one: bool = False,
    ) -> None:
        """Take tau (s), H, q_max (1/m), grad z and a table of steady friction over velocity (m/s).

        The table is interpolated in log v, in proportion to v below it and constant above it.
        Raises ValueError for values without meaning.
        """
        self.velocity = np.asarray(velocity, dtype=float)
        self.friction = np.asarray(friction, dtype=float)
        if self.velocity.ndim != 1 or self.velocity.shape != self.friction.shape:
            raise ValueError("velocity and friction must be one-dimensional and of one length")
        if self.velocity.size < 2 or (np.diff(self.velocity) <= 0).any() or self.velocity[0] <= 0:
            raise ValueError("velocity must hold two or more increasing positive values")
        if min(relaxation_time, q_max, rms_slope) <= 0 or not 0 <= hurst <= 1:
            raise ValueError("relaxation_time, q_max, rms_slope must be positive, hurst in [0, 1]")
        self.relaxation_time = relaxation_time
        self.hurst = hurst
        self.q_max = q_max
        self.rms_slope = rms_slope
        self.time_below_one = time_below_one

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return the steady friction mu(v); v in m/s, any shape."""
        v = np.asarray(v, dtype=float)
        inside = np.interp(
            np.log(np.maximum(v, self.velocity[0])), np.log(self.velocity), self.friction
        )
        return inside * np.minimum(v / self.velocity[0], 1.0)

    def jump(self, v1: ArrayLike, v2: ArrayLike) -> np.ndarray:
        """Return the instantaneous change of mu when v1 becomes v2 (eq. 12)."""
        mu_bar = self.steady(v1) / self.rms_slope
        return self.rms_slope * normalised_jump(mu_bar) * (v2 / np.asarray(v1) - 1.0)

    def relaxation_times(self, v: ArrayLike) -> np.ndarray:
        """Return the relaxation time tau/b in s; above v tau q_max = 1 it is eq. 16."""
        x = np.asarray(v, dtype=float) * self.relaxation_time * self.q_max
        return self.relaxation_time / relaxation_rate(x, self.hurst, self.time_below_one)

    def relaxation_length(self, v: ArrayLike) -> np.ndarray:
        """Return the distance slid in a relaxation time, in m: D_c = 1/q_max below x = 1."""
        return np.asarray(v) * self.relaxation_times(v)

    def after_jump(self, v1: float, v2: float, time: ArrayLike) -> np.ndarray:
        """Return mu(t) for a jump from v1 to v2 at t = 0; time in s, mu(v1) for t < 0.

        Eqs. 14 and 15 with mu(v2) for its linearisation mu(v1) + mu'(v1) dv, which eq. 8 has.
        """
        time = np.asarray(time, dtype=float)
        mu_1, mu_2 = self.steady(v1), self.steady(v2)
        amplitude = mu_1 + self.jump(v1, v2) - mu_2
        decay = np.exp(-np.maximum(time, 0.0) / self.relaxation_times(v1))
        return np.where(time < 0.0, mu_1, mu_2 + amplitude * decay)

    def response(self, time: ArrayLike, velocity: ArrayLike) -> np.ndarray:
        """Return mu at sampled times (s, increasing) for sampled velocities (m/s, positive).

        v(t) is a sequence of small jumps, one per sample; what each leaves over its steady value
        decays with the relaxation time at the velocity since then. Sliding is steady before.
        """
        time, velocity = np.asarray(time, dtype=float), np.asarray(velocity, dtype=float)
        if time.shape != velocity.shape or time.ndim != 1 or (np.diff(time) <= 0).any():
            raise ValueError("time must increase, and velocity hold one value per time")
        if (velocity <= 0).any():
            raise ValueError("velocity must be positive")
        mu = self.steady(velocity)
        left = np.diff(mu, prepend=mu[0])
        fresh = np.concatenate([[0.0], self.jump(velocity[:-1], velocity[1:])]) - left
        keep = np.exp(-np.diff(time, prepend=time[0]) / self.relaxation_times(velocity))
        excess = np.empty_like(mu)
        now = 0.0
        for k in range(mu.size):
            now = now * keep[k] + fresh[k]
            excess[k] = now
        return mu + excess
