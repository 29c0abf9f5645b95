"""Search for the rate-and-state or LuGre law that fits motions best."""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from .fitted_law import Validity
from .reduced_law import Law
from .residuals import extent_of, friction, residuals, root_mean_square
from .transients import Transient
from .usual_laws import LuGreLaw, RateStateLaw

MAX_PARAMETER_CHANGE = 12.0  # from the initial guess; most parameters are logarithms
GUESSED_LENGTH = 0.05  # initial length, relative to the mean distance of a segment
MIN_FRICTION_SCALE = 1e-300


class UsualStart(NamedTuple):
    """Constructor of a law from its parameters, and the initial parameters."""

    make: Callable[[np.ndarray], Law]
    parameters: np.ndarray


class UsualSearch:
    """Least-squares search for a rate-and-state law (ageing or slip) or a LuGre law."""

    def __init__(self, motions: Sequence[Transient], speeds: np.ndarray, kind: str) -> None:
        self.validity = Validity(slowest=float(speeds[1]), fastest=float(speeds[-1]))
        self.mu_scale = max(root_mean_square(friction(motions)), MIN_FRICTION_SCALE)
        self.mean_speed = float(np.sqrt(speeds[1] * speeds[-1]))
        extent = extent_of(motions)
        length = math.log(GUESSED_LENGTH * extent.distance / extent.segments)
        if kind == RateStateLaw.kind:
            self.guess = np.array([-2.0, 0.05, length, 1.0])
            makers = [partial(self._rate_state, ageing=ageing) for ageing in (False, True)]
            self.starts = [UsualStart(make, self.guess) for make in makers]
        else:
            self.guess = np.array([math.log(self.mu_scale) - length, 0.0, 0.0, 0.0, 0.0, 0.0])
            self.starts = [UsualStart(self._lugre, self.guess)]

    def fit(
        self, motions: Sequence[Transient], max_evaluations: int, start: UsualStart | None = None
    ) -> tuple[Law, UsualStart]:
        """Return the law that fits the known friction best, and a start for further fits.

        max_evaluations : of the residuals, without those for derivatives.
        """
        bounds = self.guess - MAX_PARAMETER_CHANGE, self.guess + MAX_PARAMETER_CHANGE
        fits = []
        for make, guess in [start] if start else self.starts:
            best = least_squares(
                lambda p, make=make: residuals(make(p), motions) / self.mu_scale,
                guess,
                bounds=bounds,
                x_scale="jac",
                max_nfev=max_evaluations,
            )
            fits.append((best.cost, UsualStart(make, best.x)))
        _, best_start = min(fits, key=lambda fit: fit[0])
        return best_start.make(best_start.parameters), best_start

    def _rate_state(self, p: np.ndarray, ageing: bool) -> Law:
        """Return the law for p = (ln a, b, ln D_c, mu*), with a, b and mu* in units of mu_scale."""
        return RateStateLaw(
            a=self.mu_scale * math.exp(p[0]),
            b=self.mu_scale * p[1],
            length=math.exp(p[2]),
            mu=self.mu_scale * p[3],
            velocity=self.mean_speed,
            ageing=ageing,
            validity=self.validity,
        )

    def _lugre(self, p: np.ndarray) -> Law:
        """Return the law for scaled (ln sigma_0, sigma_1, sigma_2, ln mu_c, ln mu_s, ln v_s)."""
        coulomb, static = map(float, self.mu_scale * np.exp(p[3:5]))
        damping, viscous = map(float, p[1:3] * self.mu_scale / self.mean_speed)
        return LuGreLaw(
            stiffness=math.exp(p[0]),
            damping=damping,
            viscous=viscous,
            coulomb=coulomb,
            static=static,
            stribeck=self.mean_speed * math.exp(p[5]),
            validity=self.validity,
        )
