"""Residuals of one velocity step, measured on the state of every element at every step.

The kernels give the indentation; the displacements under it are worked out here, element by
element, and held against the equations of the model. Residuals are relative to their terms.
"""

from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    Kelvin,
    Line,
    State,
    lagged_slope,
    march,
    solve_indentation,
    steady_sliding,
)
from elastomer_friction.kernels.model.steady import sweep

TINY = np.finfo(float).tiny  # the smallest normal number
EPS = np.finfo(float).eps
STAY = 20  # steps for which steady sliding has to stay as it is
RESIDUALS = {
    "balance": "sum f = F_N (eq. 4)",
    "mean": "mean of -u = F_N/(4GL) (eq. 2 summed)",
    "contact": "f >= 0, u <= z - d, one of them equal",
    "energy": "work = elastic energy + dissipation",
    "steady": "steady sliding marched on stays steady",
    "march": "d by stretches that can touch = d of all elements",
}
COUNTS = {
    "falling": "places where F_N(d) falls",
    "subnormal": "subnormal numbers in the state",
    "not_finite": "numbers that are none",
    "passes": "Newton passes of one step, at most",
    "sweeps": "sweeps of one steady state, at most",
}


class Motion(NamedTuple):
    """A line under load, and a velocity step."""

    line: Line
    load: float  # Fbar
    speed: float  # vbar before
    ratio: float  # after / before
    scheme: str

    def step(self, ratio: float) -> tuple[float, Kelvin]:
        """Return dt and the law for a step at ``ratio`` times the speed."""
        dt = 1.0 / (self.line.steps_per_spacing * self.speed * ratio)
        return dt, SCHEMES[self.scheme](dt)

    def steady(self, law: Kelvin) -> tuple[State, int]:
        """Return the state of steady sliding, and the sweeps it took."""
        return steady_sliding(law, self.line.z, self.total)

    @property
    def total(self) -> float:
        """The load on the whole line."""
        return self.load * self.line.z.size


def probe(motion: Motion, steps: int) -> dict[str, float]:
    """Return the worst residual of each kind, and the counts, over ``steps`` after the jump."""
    worst = dict.fromkeys((*RESIDUALS, *COUNTS), 0.0)
    starts = []
    for ratio in (1.0, motion.ratio):
        dt, law = motion.step(ratio)
        state, sweeps = motion.steady(law)
        starts.append(state)
        w, d = state
        subnormal = np.sum((w != 0.0) & (np.abs(w) < TINY))
        _raise(worst, sweeps=sweeps, falling=_falling(motion.line.z, d, law), subnormal=subnormal)
        _raise(worst, not_finite=np.sum(~np.isfinite(w)))
        depths = _follow(motion, state, dt, law, 1.02 * d, STAY, worst)
        _raise(worst, steady=np.max(np.abs(depths / d - 1.0)))
    _follow(motion, starts[0], dt, law, 1.02 * max(d for _, d in starts), steps, worst)
    return worst


def _march(motion, state, law, cap, steps, worst):
    """Return the indentations after each step by the kernels, marched as run_case does."""
    weight, control = lagged_slope(motion.line.slope, law.lag), ConstantForce(motion.total)
    kept_steps = np.arange(1, steps + 1)
    for highest in (cap, 1.001 * max(state.d, motion.total)):
        mu, depths, _, inside = march(
            law, control, motion.line.z, weight, state, kept_steps, highest
        )
        if inside:
            break
    _raise(worst, not_finite=np.sum(~np.isfinite(mu)) + np.sum(~np.isfinite(depths)))
    return depths


def _follow(motion, state, dt, law, cap, steps, worst):
    """Let every element follow the indentations of a march, keep the worst residuals; return d."""
    z, total = motion.line.z, motion.total
    depths = _march(motion, state, law, cap, steps, worst)
    u, d = np.minimum(state.w, z - state.d), state.d
    for depth in depths:
        old = np.roll(u, -1)
        free = law.decay * old
        d, passes = solve_indentation(z - free, total / law.stiffness, d)
        u = np.minimum(free, z - depth)
        force = law.stiffness * (free - u)
        _raise(
            worst,
            balance=abs(np.sum(force) / total - 1.0),
            mean=abs(-np.sum(u) / total - 1.0),
            contact=_contact(force, (z - depth) - u, depth),
            energy=_energy(motion.scheme, dt, old, u, force),
            march=abs(d / depth - 1.0),
            passes=passes,
        )
        d = depth
    return depths


def _contact(force, gap, d):
    """Return how far an element presses and stands off at once, pulls, or passes through."""
    pressed, apart = force / force.max(), gap / d
    return max(np.max(np.minimum(pressed, apart)), -pressed.min(), -apart.min())


def _energy(scheme, dt, old, new, force):
    """Return |work - elastic energy - dissipation| relative to the sizes of its terms.

    Exponential: the force is constant over a step, and the motion under it exact. Implicit
    Euler dissipates (u - u_old)^2 / 2 of its own. Both are sums of squares: none is created.
    """
    work = -force * (new - old)
    elastic = 0.5 * (new - old) * (new + old)
    if scheme == "exponential":
        dissipated = -0.5 * np.expm1(-2.0 * dt) * (old + force) ** 2
    else:
        dissipated = (1.0 / dt + 0.5) * (new - old) ** 2
    # At rest all terms are rounding of the stored energy.
    size = np.sum(np.abs(work) + np.abs(elastic) + dissipated + EPS * old**2)
    return abs(np.sum(work - elastic - dissipated)) / size


def _falling(z, d, law):
    """Return how often the force of steady sliding fails to rise with the indentation."""
    w = np.empty_like(z)
    depths = d * np.geomspace(0.01, 100.0, 25)
    force = [sweep(law, z, depth, int(np.argmin(z)), w)[0] for depth in depths]
    return int(np.sum(np.diff(force) <= 0.0))


def _raise(worst: dict[str, float], **found: float) -> None:
    """Keep the larger value of each kind; what is no number counts as infinite."""
    for kind, value in found.items():
        worst[kind] = max(worst[kind], float(value) if np.isfinite(value) else np.inf)
