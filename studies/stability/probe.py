"""Residuals of a velocity step, measured on the state of every element at every step.

The kernels give the indentation; this module computes the displacements of all elements from it
and inserts them into the equations of the model. Residuals are relative to their terms. The cases
are all corners on random lines, artificial lines without a spectrum, and very long lines.
"""

import itertools
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import (
    SCHEMES,
    Case,
    ConstantForce,
    Kelvin,
    Line,
    Quantities,
    State,
    amplitudes,
    draw_phases,
    lagged_slope,
    march,
    rms_slope,
    run_case,
    solve_indentation,
    steady_sliding,
)
from elastomer_friction.kernels.model.steady import sweep

TINY = np.finfo(float).tiny  # the smallest normal number
EPS = np.finfo(float).eps
STEADY_STEPS = 20  # number of steps in which steady sliding must not change
RESIDUALS = {
    "balance": "sum f = F_N (eq. 4)",
    "mean": "mean of -u = F_N/(4GL) (eq. 2 summed)",
    "contact": "f >= 0, u <= z - d, one of them equal",
    "energy": "work = elastic energy + dissipation",
    "steady": "steady sliding marched on stays steady",
    "march": "d from elements that can touch = d from all elements",
}
COUNTS = {
    "falling": "places where F_N(d) falls",
    "subnormal": "subnormal numbers in the state",
    "not_finite": "numbers that are not finite",
    "passes": "largest number of Newton passes of a step",
    "sweeps": "largest number of sweeps of a steady state",
}
HURST = (0.0, 0.5, 1.0)
ELEMENTS = ((8, 1), (8, 4), (64, 2), (1000, 1))  # N and samples per spacing
LOADS = (1e-6, 1e-3, 1.0, 1e4)
X = (1e-4, 1.0, 1e3, 1e6)
RATIOS = (1e-3, 0.8, 1.2, 101.0)  # dv/v1 = -0.999 to +100
LONG = (10**5, 10**6)
LONG_STEPS = 2


class Motion(NamedTuple):
    """A line under load, and a velocity step."""

    line: Line
    load: float  # Fbar
    speed: float  # vbar before the step
    ratio: float  # v2 / v1
    scheme: str

    def step(self, ratio: float) -> tuple[float, Kelvin]:
        """Return dt and the law for a step at ``ratio`` times the speed."""
        dt = 1.0 / (self.line.steps_per_spacing * self.speed * ratio)
        return dt, SCHEMES[self.scheme](dt)

    def steady(self, law: Kelvin) -> tuple[State, int]:
        """Return the state of steady sliding and its number of sweeps."""
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
        scratch = np.empty_like(w)
        deeper, deepest = d * np.geomspace(0.01, 100.0, 25), int(np.argmin(motion.line.z))
        force = [sweep(law, motion.line.z, depth, deepest, scratch)[0] for depth in deeper]
        falling = sum(
            b <= a for a, b in pairwise(force)
        )  # pairs between which the force does not rise
        _keep_largest(worst, sweeps=sweeps, falling=falling, subnormal=subnormal)
        _keep_largest(worst, not_finite=np.sum(~np.isfinite(w)))
        depths = _follow(motion, state, dt, law, 1.02 * d, STEADY_STEPS, worst)
        _keep_largest(worst, steady=np.max(np.abs(depths / d - 1.0)))
    _follow(motion, starts[0], dt, law, 1.02 * max(d for _, d in starts), steps, worst)
    return worst


def refinement(motion: Motion, fine: Line, hurst: float) -> float:
    """Return the change of mu_1 on halving the sample spacing, in units of the rms slope."""
    case = Case(motion.load, motion.speed, (), (), motion.scheme)
    steady = Quantities(jump=False, relaxation=False)
    one, two = (run_case(line, case, steady).mu_1 for line in (motion.line, fine))
    elements = fine.z.size // fine.steps_per_spacing
    return abs(two - one) / rms_slope(amplitudes(hurst, elements), elements)


def _follow(motion, state, dt, law, cap, steps, worst):
    """March as run_case does and update the worst residuals over all elements.

    Return the indentations after all steps.
    """
    z, total = motion.line.z, motion.total
    weight, control = lagged_slope(motion.line.slope, law.lag), ConstantForce(total)
    kept_steps = np.arange(1, steps + 1)
    for highest in (cap, 1.001 * max(state.d, total)):
        mu, depths, _, inside = march(law, control, z, weight, state, kept_steps, highest)
        if inside:
            break
    _keep_largest(worst, not_finite=np.sum(~np.isfinite(mu)) + np.sum(~np.isfinite(depths)))
    u, d = np.minimum(state.w, z - state.d), state.d
    for depth in depths:
        old = np.roll(u, -1)
        free = law.decay * old
        d, passes = solve_indentation(z - free, total / law.stiffness, d)
        u = np.minimum(free, z - depth)
        force = law.stiffness * (free - u)
        # Violation of complementarity, tension, or penetration of an element.
        pressed, apart = force / force.max(), ((z - depth) - u) / depth
        _keep_largest(
            worst,
            balance=abs(np.sum(force) / total - 1.0),
            mean=abs(-np.sum(u) / total - 1.0),
            contact=max(np.max(np.minimum(pressed, apart)), -pressed.min(), -apart.min()),
            energy=_energy(motion.scheme, dt, old, u, force),
            march=abs(d / depth - 1.0),
            passes=passes,
        )
        d = depth
    return depths


def _energy(scheme, dt, old, new, force):
    """Return |work - elastic energy - dissipation| relative to the sizes of its terms.

    Exponential scheme: the force is constant over a step, and the motion under it exact. Implicit
    Euler has an extra numerical dissipation (u - u_old)^2 / 2. Both are sums of squares.
    """
    work = -force * (new - old)
    elastic = 0.5 * (new - old) * (new + old)
    if scheme == "exponential":
        dissipated = -0.5 * np.expm1(-2.0 * dt) * (old + force) ** 2
    else:
        dissipated = (1.0 / dt + 0.5) * (new - old) ** 2
    # At rest all terms are rounding errors of the stored energy.
    size = np.sum(np.abs(work) + np.abs(elastic) + dissipated + EPS * old**2)
    return abs(np.sum(work - elastic - dissipated)) / size


def _keep_largest(worst: dict[str, float], **values: float) -> None:
    """Keep the larger value of each kind; a NaN counts as infinite."""
    for kind, value in values.items():
        worst[kind] = max(worst[kind], float(value) if np.isfinite(value) else np.inf)


def line_through(z, steps_per_spacing: int = 2) -> Line:
    """Return the periodic line through these heights."""
    z = np.asarray(z, dtype=float)
    slope = 0.5 * steps_per_spacing * (np.roll(z, -1) - np.roll(z, 1))
    return Line.from_samples(z, slope, steps_per_spacing)


def shapes(n: int = 48) -> dict[str, Line]:
    """Return artificial lines of n samples by name. n : a multiple of 8."""
    x = np.arange(n)
    quantised = np.round(4.0 * np.random.default_rng(3).normal(size=n)) / 4.0
    heights = {
        "flat": np.zeros(n),
        "spike down": np.where(x == n // 2, -1.0, 1.0),
        "spike up": np.where(x == n // 2, 1.0, -1.0),
        "needle of 1000": np.where(x == n // 2, -1000.0, 0.0),
        "step": np.where(x < n // 2, -1.0, 1.0),
        "comb": np.where(x % 2 == 0, -1.0, 1.0),
        "sawtooth": x % 8 - 3.5,
        "falling sawtooth": 3.5 - x % 8,
        "ties at the bottom": np.where(x % 8 < 3, -2.0, np.sin(x)),
        "quantised": quantised,
        "far from zero": 1e6 + quantised,
        "nearly flat": 1e-12 * np.sin(x),
        "two samples apart by one ulp": np.where(x == 5, 1.0, np.where(x == 9, 1.0 + 2e-16, 2.0)),
    }
    return {name: line_through(z) for name, z in heights.items()}


class Corner(NamedTuple):
    """A case: name of the line, number of elements, motion and number of steps."""

    line: str
    elements: int
    motion: Motion
    steps: int


def random_line(hurst: float, elements: int, m: int, seed: int, index: int) -> Line:
    """Return a random line, determined by its arguments alone."""
    rng = np.random.default_rng([seed, round(1e6 * hurst), elements, index])
    return Line.self_affine(amplitudes(hurst, elements), draw_phases(rng, elements), elements, m)


def corners(seed: int, lines: int, most_elements: int, steps: int) -> Iterator[Corner]:
    """Yield all cases, generating the lines on demand."""
    for hurst, (n, m), index in itertools.product(HURST, ELEMENTS, range(lines)):
        line = random_line(hurst, n, m, seed, index)
        yield from _every_motion(f"H = {hurst:g}", n, line, RATIOS, steps)
    for name, line in shapes().items():
        n = line.z.size // line.steps_per_spacing
        yield from _every_motion(name, n, line, (RATIOS[0], RATIOS[-1]), steps)
    for n in LONG:
        if n <= most_elements:
            line = random_line(1.0, n, 1, seed, 0)
            for load, scheme in itertools.product((LOADS[0], LOADS[-1]), SCHEMES):
                yield Corner("H = 1", n, Motion(line, load, 10.0, 2.0, scheme), LONG_STEPS)


def _every_motion(name, elements, line, ratios, steps):
    for load, x, ratio, scheme in itertools.product(LOADS, X, ratios, SCHEMES):
        yield Corner(name, elements, Motion(line, load, x / np.pi, ratio, scheme), steps)


def count_corners(lines: int, most_elements: int) -> int:
    """Return the number of cases that ``corners`` yields."""
    motions = len(LOADS) * len(X) * len(SCHEMES)
    random = len(HURST) * len(ELEMENTS) * lines * motions * len(RATIOS)
    long = sum(n <= most_elements for n in LONG)
    return random + len(shapes()) * motions * 2 + long * 2 * len(SCHEMES)
