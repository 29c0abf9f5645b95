"""Predicted cost of a case: how much work it is, in seconds of a typical machine, by part.

The amounts (samples, edges of contacts, steps) belong to the problem; how much longer a machine
takes than the typical one is its pace (pace.py). Laws take a problem, or many of them together
(problems.py).
"""

from typing import NamedTuple

import numpy as np

from kernels import KELVIN, Quantities, Spectrum
from kernels.patches.refined import FINE, LEAST_STEPS, MOST_SAMPLES, NARROW
from workflow.plan.cost.sizes import STEP, SWEEP
from workflow.plan.error_laws import contact_width
from workflow.plan.problems import Numbers, speed_ratio, viscous_pressure
from workflow.simulate import PHASES, Problem, Recording, lines_at_once, programme_steps

PARTS = (*PHASES, "calls")  # of the time of a realization; the first is the drawing of its line
DRAWING, STEADY, JUMP, MARCHING, CALLS = PARTS
# Kinds of work that laws describe differently well; a variant is of one.
PLAIN, BRANCHES, PROGRAMME = "plain", "branches", "programme"

# Of elements with internal variables, in steps (of all samples) and sweeps of a Kelvin element.
# Ratios of CPU times on one machine, H = 0.7, m = 4, Prony series without a dashpot. March at
# N = 1000, Fbar = 0.3, vbar = 1: 1.07, 2.03 and 4.91 steps with 1, 4 and 13 branches. Steady states
# there 165, 230 and 394 sweeps; at N = 4000 93 and 208 with 1 and 13; at other loads and speeds 85
# to 185 with 4: the line through them is within a factor of two. Of 96 batches of all studies with
# such elements steps took as long, and steady states 1.2 to 3 times as long as vbar grew to 1e8.
DENSE = 0.75  # of a step: moves, forces, friction
UNIT = 0.32  # of a step, for each internal variable
SHIFT = 12.0  # steps, to shift the line to between its samples
NEWTON = 118.0  # sweeps of a steady state at rest
TANGENT = 17.0  # sweeps, for each internal variable
FASTER = 0.083  # of them more, for each factor of e in the speed


CALL = 1.2e-4  # s, calls from Python for elements with internal variables


class Work(NamedTuple):
    """What is computed of a problem on each line, or of many together."""

    problem: Problem
    steps: Numbers  # per spacing
    march_steps: Numbers  # after the jump; 0: none
    refine: bool = True  # narrow contacts are read from finer samples
    loads: Numbers = 1  # on the same lines at the same speed, which share sweeps
    tasks: Numbers = 1  # on the same lines

    @property
    def samples(self) -> Numbers:
        """Number of samples of the line."""
        return self.problem.elements * self.steps

    @property
    def units(self) -> int:
        """Number of internal variables of an element."""
        return len(self.problem.spectrum.moduli) + (self.problem.spectrum.viscosity > 0.0)


def kind_of(spectrum: Spectrum, recording: Recording) -> str:
    """Return of which kind work on problems of a spectrum is."""
    if recording.asked:
        return PROGRAMME
    return PLAIN if spectrum == KELVIN else BRANCHES


def touchable_share(hurst: Numbers, load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the share of the line that is marched: what lies below the indentation.

    At rest it grows with the load; at speed little area carries it, load over viscous pressure.
    Measured on 1500 random problems, Fbar 1e-4 ... 30, vbar 0.02 ... 1000, N 700 ... 12000: half of
    them within 20 %, nine of ten within a factor of 2.2.
    """
    rest = np.exp(-0.40 + 0.78 * hurst) * load**0.635
    speed = np.exp(1.58 + 0.44 * hurst) * (load / viscous_pressure**0.72) ** 1.06
    return (1.0 + rest**-2.8 + speed**-2.8) ** (-1.0 / 2.8)


def partial_contact(load: Numbers, viscous_pressure: Numbers, limit: float) -> Numbers:
    """Return 1 where part of a line touches and 0 where all of it does, at loads over a limit."""
    return 1.0 / (1.0 + (load / (1.0 + viscous_pressure) / limit) ** 4)


def begun_anew(problem: Problem) -> Numbers:
    """Return how much longer marches take that begin anew, with wider bounds (kernels/active).

    Near H = 1 and above x = 1e4 most do. Of 60 batches of grid6d at paper scale, together as long
    as predicted with it, half are within a factor of two, and nine of ten within ten.
    """
    near_one = 1.0 / (1.0 + np.exp((0.83 - problem.hurst) / 0.03))
    return 1.0 + 1.5 * near_one / (1.0 + (1e4 / speed_ratio(problem)) ** 2)


def fine_samples(problem: Problem, samples: Numbers, share: Numbers, width: Numbers) -> Numbers:
    """Return the fine samples of a steady state, where contacts are narrow (kernels/patches).

    share : of the line that can touch. width : of the contacts, in samples.
    """
    odds = (samples / problem.elements >= LEAST_STEPS) & (speed_ratio(problem) >= 1.0)
    fold = 1.46 * FINE / np.maximum(width, 0.05)  # a power of two, between this and twice that
    whole = samples * np.minimum(1.2 * share, 1.0) * fold
    few = 1.0 / (1.0 + (whole / (0.6 * MOST_SAMPLES)) ** 2)  # of more it takes none
    return odds * few * whole / (1.0 + (width / (0.92 * NARROW)) ** 4)


def typical_seconds(asked: Quantities, work: Work, recording: Recording) -> dict[str, Numbers]:
    """Return part -> time of one realization on a line that exists, of the typical machine."""
    found: dict[str, Numbers] = dict.fromkeys(PARTS, 0.0)
    found[CALLS] = CALL * (1 + bool(recording.asked))
    if asked.anything:
        found |= (_kelvin if work.problem.spectrum == KELVIN else _memory)(asked, work)
    if recording.asked:
        problem = work.problem
        begins = problem.start == "steady" and problem.spectrum != KELVIN
        found[MARCHING] = found[MARCHING] + _programme(work) + begins * _memory_state(work)
        first, last = problem.ends
        others = (first != problem.speed) | (last != problem.ratio * problem.speed)
        found[CALLS] = found[CALLS] + asked.steady * others * found[STEADY]
    return found


def _programme(work: Work) -> Numbers:
    """Return the time of the steps of a programme, which the steps per spacing say."""
    different, inverse = np.unique(work.steps, return_inverse=True)
    counts = []
    for steps in different:
        moved = programme_steps(work.problem, int(steps)).moved
        between = np.abs(moved - np.round(moved)) > 1e-6  # of a sample
        counts.append((moved.size, np.count_nonzero(between)))
    whole, shifted = np.array(counts)[inverse].T
    return whole * _dense_step(work) + SHIFT * shifted * STEP(work.samples)


def _kelvin(asked: Quantities, work: Work) -> dict[str, Numbers]:
    """Return the time of a case of Kelvin elements, which goes with the edges of contacts.

    The more loads there are at a speed, the more sweeps they share. Over 201 batches of all studies
    and scales nine in ten are within a factor of 1.6 (steady states) and 1.5 (the rest). What is
    narrower than NARROW samples on average may be refined or not, which costs a factor of ten at
    single points. Of 54 batches of 300 to 20 000 samples, x = 0.5 and 20, the whole is within 1.25
    for 47 and 1.55 for all.
    """
    problem, n = work.problem._replace(speed=np.abs(work.problem.speed)), work.samples
    load, pressure = problem.load, viscous_pressure(problem)
    share = touchable_share(problem.hurst, load, pressure)
    width = contact_width(problem) * work.steps
    edges = share / np.maximum(width, 1.0)  # per sample of the line
    fine = work.refine * fine_samples(problem, n, share, width)
    steady_states = 0.5 * (1 + (asked.steady or asked.relaxation))
    open_ones = partial_contact(load, pressure, 2.2)
    alone = 1.0 / lines_at_once(n)  # of short lines many share what a call takes
    line = 2.0e-5 + 6e-5 * alone + 1.2e-8 * n
    each = 1.7e-5 + n * (2.9e-9 + open_ones * 4.4e-7 * edges) + 4.2e-8 * fine
    together = 1.7e-5 + 8e-5 * alone + 1.7e-8 * n
    jump = 2e-6 + n * (6e-10 + 3.7e-8 * edges) + 1.6e-9 * fine
    march: Numbers = 0.0
    if asked.relaxation:
        listed = 2.3e-8 * np.exp(-1.5 * problem.hurst) * share / (np.maximum(width, 1.0) + 1.9)
        setup = 8.2e-9 + 3.9e-9 * share + 2.5e-7 * edges
        steps = begun_anew(problem) * work.march_steps
        marched = n * setup + (9.8e-7 + n * listed) * steps
        march = 7.6e-5 + partial_contact(load, pressure, 1.7) * marched
    return {
        STEADY: steady_states * (each + together / work.loads),
        JUMP: asked.jump * (jump + (2.5e-6 + 1.6e-9 * n) / work.loads),
        MARCHING: march,
        CALLS: 1.2e-5 + 1e-4 * alone / work.loads + line / work.tasks,
    }


def _memory(asked: Quantities, work: Work) -> dict[str, Numbers]:
    """Return the time of a case of elements with internal variables, all of which are marched."""
    steady_states = 1 + (asked.steady or asked.relaxation)
    march = work.march_steps * _dense_step(work)
    return {STEADY: steady_states * _memory_state(work), MARCHING: march}


def _memory_state(work: Work) -> Numbers:
    """Return the time of a steady state of elements with internal variables."""
    faster = 1.0 + FASTER * np.log1p(np.abs(work.problem.speed))
    return faster * (NEWTON + TANGENT * work.units) * SWEEP(work.samples)


def _dense_step(work: Work) -> Numbers:
    """Return the time of a step in which every element moves all that it remembers."""
    return (DENSE + UNIT * work.units) * STEP(work.samples)
