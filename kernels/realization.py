"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, one steady state at v1 serves all velocity jumps.
"""

import time
from typing import NamedTuple

import numpy as np

from kernels.friction import lagged_slope, quadrature, step_average
from kernels.relaxation import march
from kernels.schemes import SCHEMES, Step
from kernels.steady import steady_sliding
from kernels.surface import sample_line


class Line(NamedTuple):
    """A sampled rigid line, highest point first, heights above its deepest point (in h)."""

    z: np.ndarray  # shape (N m,)
    slope: np.ndarray  # shape (N m,), in h/dx
    datum: float  # height of the deepest point over the mean line, in h
    samples_per_spacing: int

    @classmethod
    def from_samples(cls, z: np.ndarray, slope: np.ndarray, samples_per_spacing: int) -> "Line":
        """Prepare given heights (in h) and slopes (in h/dx) of a periodic line.

        Raises ValueError where a sample is not finite.
        """
        if not (np.isfinite(z).all() and np.isfinite(slope).all()):
            raise ValueError("the line holds samples that are not finite numbers")
        top = int(np.argmax(z))
        # Heights over the deepest point keep full precision where light loads touch.
        datum = float(z.min())
        return cls(np.roll(z, -top) - datum, np.roll(slope, -top), datum, samples_per_spacing)

    @classmethod
    def self_affine(
        cls, amplitude: np.ndarray, phases: np.ndarray, elements: int, samples_per_spacing: int
    ) -> "Line":
        """Sample the random line of surface.py."""
        z, slope = sample_line(amplitude, phases, elements, samples_per_spacing)
        return cls.from_samples(z, slope, samples_per_spacing)


class Quantities(NamedTuple):
    """What a scene asks for."""

    steady: bool = True
    jump: bool = True
    relaxation: bool = True
    indentation_rate: bool = True  # effect: d' in the force (eq. 3 as printed drops it)


class Case(NamedTuple):
    """One load, one speed v1 and the jumps from it, on a line that is given."""

    load: float  # Fbar = F_N / (4 G L h)
    speed: float  # vbar = v1 tau / dx
    ratios: tuple[float, ...]  # v2 / v1
    records: tuple[np.ndarray, ...]  # per ratio: the steps at which the relaxation is kept
    scheme: str


class Seconds(NamedTuple):
    """CPU time of this thread in the phases of a case. No result depends on it."""

    steady: float
    jump: float
    marching: float


class Outcome(NamedTuple):
    """Results of a case; mu in h/dx, indentation in h over the mean line."""

    mu_1: float
    indentation: float
    contact_fraction: float
    mu_2: np.ndarray  # shape (ratios,)
    jump: np.ndarray  # shape (ratios,)
    curves: list[np.ndarray]  # per ratio: mu at the recorded steps, ending towards mu_2
    work: int  # element updates, the measure of cost
    seconds: Seconds


class _State(NamedTuple):
    c: np.ndarray
    d: float
    step: Step
    sweeps: int


def _steady(line: Line, load: float, speed: float, scheme: str) -> _State:
    step = SCHEMES[scheme](1.0 / (line.samples_per_spacing * speed))
    c, d, sweeps = steady_sliding(line.z, load, step.decay, step.stiffness)
    return _State(c, d, step, sweeps)


def run_case(line: Line, case: Case, asked: Quantities) -> Outcome:
    """Compute one case on one line.

    The relaxation curve is mu_2 plus the deviation of the marched step average from its own
    steady value, so that it ends at mu_2 exactly whatever the step.
    """
    n = line.z.size
    load = case.load * n
    clock = _Clock()
    one = _steady(line, load, case.speed, case.scheme)
    mu_1, _, contact = quadrature(line.z, line.slope, one.c, one.d, case.speed, case.speed, load)
    clock.lap("steady")
    work = one.sweeps * n
    mu_2 = np.full(len(case.ratios), np.nan)
    jump = np.full(len(case.ratios), np.nan)
    curves = []
    for k, ratio in enumerate(case.ratios):
        speed = ratio * case.speed
        if asked.jump:
            mu_0, _, _ = quadrature(line.z, line.slope, one.c, one.d, case.speed, speed, load)
            jump[k] = mu_0 - mu_1
            clock.lap("jump")
        if not (asked.steady or asked.relaxation):
            continue
        two = one if ratio == 1.0 else _steady(line, load, speed, case.scheme)
        work += two.sweeps * n if two is not one else 0
        mu_2[k], _, _ = quadrature(line.z, line.slope, two.c, two.d, speed, speed, load)
        clock.lap("steady")
        if asked.relaxation:
            rigid = None if asked.indentation_rate else True
            curve, updates = _relaxation(line, load, one, two, case.records[k], rigid)
            curves.append(mu_2[k] + curve)
            work += updates
            clock.lap("marching")
    seconds = Seconds(**clock.spent)
    return Outcome(mu_1, one.d + line.datum, contact, mu_2, jump, curves, work, seconds)


class _Clock:
    """Books the time since its last reading to a phase."""

    def __init__(self) -> None:
        self.spent = dict.fromkeys(Seconds._fields, 0.0)
        self.last = time.thread_time()

    def lap(self, phase: str) -> None:
        now = time.thread_time()
        self.spent[phase] += now - self.last
        self.last = now


def _relaxation(
    line: Line,
    load: float,
    one: _State,
    two: _State,
    record: np.ndarray,
    rigid: bool | None,
) -> tuple[np.ndarray, int]:
    """Return the deviation from the steady friction at v2, and the element updates."""
    step = two.step
    weight = lagged_slope(line.slope, step.lag)
    final = step_average(weight, two.c, two.d)
    # d stays between its steady values but for a transient; everything touches at worst.
    work = 0
    for cap in (1.02 * max(one.d, two.d), np.inf):
        mu, _, passes, inside = march(
            line.z, weight, one.c, one.d, step.decay, step.stiffness, load, record, cap, rigid
        )
        work += passes * line.z.size
        if inside:
            break
    return mu - final, work
