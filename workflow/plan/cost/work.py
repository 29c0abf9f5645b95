"""Predicted cost of a case: how much work it is, in seconds of a typical machine, by part.

The amounts (samples, edges of contacts, steps) belong to the problem; how much longer a machine
takes than the typical one is its pace (machine.py). Laws take a problem, or many of them together
(problems.py).
"""

from typing import NamedTuple

import numpy as np

from ....kernels import KELVIN, Quantities
from ....kernels.quick.contacts.between_samples import LEAST_STEPS
from ...simulate import (
    MAX_LISTED_STEPS,
    PHASES,
    Problem,
    Recording,
    leg_counts,
    lines_at_once,
    programme_steps,
)
from ...study import HALF_SPACE
from ..error_laws import contact_width
from ..half_space import PASS, WARM, passes_of
from ..problems import Numbers, speed_ratio, viscous_pressure

PARTS = (*PHASES, "calls")  # of the time of a realization; the first is the drawing of its line
DRAWING, STEADY, JUMP, MARCHING, CALLS = PARTS
# Kinds of work that laws describe differently well; a variant is of one.
PLAIN, BRANCHES, PROGRAMME, MAPS = "plain", "branches", "programme", "maps"

# Of elements with internal variables, in steps (of all samples) and sweeps of a Kelvin element.
# Ratios of CPU times on one machine, m = 4, Prony series without a dashpot. Marches of the implicit
# Euler scheme at H = 0.7, N = 1000, Fbar = 0.3, vbar = 1: 1.07, 2.03 and 4.91 steps with 1, 4 and
# 13 branches. The exponential scheme moves what can touch, in blocks: at H = 0.7, N = 5000,
# vbar = 5 it takes 0.22 and 0.50 steps with 1 and 13 branches where 0.18 of the line can, and 0.93
# and 2.3 where all of it can. Of 40 random marches, H 0.2 to 1, N 200 to 15 000, Fbar 0.003 to 3,
# vbar 0.1 to 1000, up to 13 branches, two in three are within a factor of 1.35 of the laws, and all
# within 2.2. Of 24 steady states with their friction, H = 0.7, N 500 and 5000, Fbar 0.05 and 1,
# vbar 1 and 100, with 1, 5 and 13 branches, all are within 1.5.
DENSE, UNIT = 0.75, 0.32  # of a step in which all elements are moved, and for each variable
LEFT, MOVED, MOVED_UNIT = 0.04, 0.8, 0.115  # of one in which those are that can touch
EDGES = 20.0  # samples of blocks beyond what can touch, for each of (samples of the line)**0.37
ONE_STEP = 1e-6  # s, of any such step
# Steps, of one by a drive: 0.9 to 2.6, up to 3.7 where 13 branches slip, and up to 150 where the
# slider goes to and fro on its spring, which no law here foresees.
PULLED = 2.0
SHIFT = 12.0  # steps, to shift the line to between its samples
NEWTON = 11.0  # sweeps of a steady state at rest
TANGENT = 1.2  # sweeps, for each internal variable
FASTER = 0.05  # of them more, for each factor of e in the speed
NO_PRESSURE = 1e-9  # viscous, in units of G h
CALL = 1.2e-4  # s, calls from Python for elements with internal variables


class Work(NamedTuple):
    """What is computed of a problem on each line, or of many together."""

    problem: Problem
    steps: Numbers  # per spacing
    march_steps: Numbers  # after the jump; 0: none
    refine: bool = True  # contacts are followed between the samples
    loads: Numbers = 1  # on the same lines at the same speed, which share sweeps
    tasks: Numbers = 1  # on the same lines
    scheme: str = "exponential"

    @property
    def samples(self) -> Numbers:
        """Number of samples of the line, or of the map."""
        return self.problem.samples(self.steps)

    @property
    def units(self) -> int:
        """Number of internal variables of an element."""
        return len(self.problem.spectrum.moduli) + (self.problem.spectrum.viscosity > 0.0)


def kind_of(problem: Problem, recording: Recording) -> str:
    """Return of which kind work on problems like this one is."""
    if problem.surface.body == HALF_SPACE:
        return MAPS
    if recording.requested:
        return PROGRAMME
    return PLAIN if problem.spectrum == KELVIN else BRANCHES


def typical_seconds(asked: Quantities, work: Work, recording: Recording) -> dict[str, Numbers]:
    """Return part -> time of one realization on a line that exists, of the typical machine."""
    found: dict[str, Numbers] = dict.fromkeys(PARTS, 0.0)
    if work.problem.surface.body == HALF_SPACE:
        return found | _half_space(asked, work, recording)
    found[CALLS] = CALL * (1 + bool(recording.requested))
    if asked.anything:
        if work.problem.spectrum == KELVIN:
            found |= _kelvin(asked, work)
        else:  # elements with internal variables, all of which are marched
            states = 1 + (asked.steady or asked.relaxation)
            found[STEADY] = states * _memory_state(work)
            found[MARCHING] = work.march_steps * _memory_step(work)
    if recording.requested:
        problem = work.problem
        begins = problem.start == "steady" and problem.spectrum != KELVIN
        found[MARCHING] = found[MARCHING] + _programme(work) + begins * _memory_state(work)
        first, last = problem.ends
        others = (first != problem.speed) | (last != problem.ratio * problem.speed)
        found[CALLS] = found[CALLS] + asked.steady * others * found[STEADY]
    return found


def _half_space(asked: Quantities, work: Work, recording: Recording) -> dict[str, Numbers]:
    """Return the time of a case on a half-space, which goes with passes over its map."""
    steady, march = passes_of(work.problem, work.steps, work.march_steps, asked)
    if recording.requested:
        different, inverse = np.unique(work.steps, return_inverse=True)
        counts = [leg_counts(work.problem, int(steps)).sum() for steps in different]
        march = march + WARM * np.array(counts)[inverse]
    each = PASS * work.samples
    return {
        STEADY: asked.anything * steady * each,
        JUMP: asked.jump * 4.0 * WARM * each,
        MARCHING: march * each,
    }


def _programme(work: Work) -> Numbers:
    """Return the time of the steps of a programme, which the steps per spacing say."""
    different, inverse = np.unique(work.steps, return_inverse=True)
    counts = []
    for steps in different:
        count, between = leg_counts(work.problem, int(steps)).sum(), 0
        if count <= MAX_LISTED_STEPS:
            moved = programme_steps(work.problem, int(steps)).moved
            between = int(np.sum(np.abs(moved - np.round(moved)) > 1e-6))  # of a sample
        counts.append((count, between))
    whole, shifted = np.array(counts)[inverse].T
    whole = whole * (PULLED if work.problem.drive else 1.0)
    return whole * _memory_step(work) + SHIFT * shifted * step_seconds(work.samples)


def _kelvin(asked: Quantities, work: Work) -> dict[str, Numbers]:
    """Return the time of a case of Kelvin elements, which goes with the edges of contacts.

    The more loads there are at a speed, the more sweeps they share. Of 43 batches of figure 7 at
    paper scale, drawn by their cost, two in three are within a factor of 1.2.
    """
    work = work._replace(problem=work.problem._replace(speed=np.abs(work.problem.speed)))
    problem, n, followed = work.problem, work.samples, work.refine & (work.steps >= LEAST_STEPS)
    partial = partial_contact(problem.load, viscous_pressure(problem))
    share = partial * touchable_share(problem.hurst, problem.load, viscous_pressure(problem))
    width = np.maximum(contact_width(problem) * work.steps, 0.05)
    edges = share * np.exp(-1.25 * problem.hurst) / np.cbrt(np.maximum(width, 1.0))
    sampled = n * (1.2e-9 + 1.0e-7 * edges)
    patches = 2.3e-6 * partial * followed_patches(problem)
    between = partial * 2.4e-9 * n + patches
    polynomials = followed * 8e-8 * problem.elements / work.tasks
    alone = 1.0 / lines_at_once(n)  # of short lines many share what a call takes
    together = 3.2e-5 * alone + 9.5e-9 * n
    state = 2.0e-5 + np.where(followed, between, sampled) + together / work.loads
    # A steady state takes longer where a jump or a march begins from it.
    states = 0.78 + 0.22 * asked.jump + 0.6 * asked.relaxation
    line = 1.8e-5 + 1.4e-5 * alone + 9e-9 * n
    return {
        STEADY: states * state + polynomials,
        JUMP: asked.jump * np.where(followed, 0.23 * polynomials + 0.35 * patches, 0.147 * state),
        MARCHING: asked.relaxation * _march(work, share, width),
        CALLS: 2.5e-5 + 5.6e-5 * alone / work.loads + line / work.tasks,
    }


def _march(work: Work, share: Numbers, width: Numbers) -> Numbers:
    """Return the time of a march of Kelvin elements, of which little is listed under heavy loads.

    share : of the line, that is partly in contact. The more the speed changes the farther d moves,
    and the longer lists are. Of 220 batches of figure 7 and grid6d at paper scale, up to 3e6 steps,
    drawn by their cost, two cases in three are within a factor of two; long marches of the same
    problem on two lines may differ by ten.
    """
    problem, width = work.problem, np.maximum(width, 1.0)
    moved = np.clip(5.0 * np.abs(problem.ratio - 1.0), 0.25, 1.0)
    listed = moved * np.exp(-2.4 * problem.hurst**2) / (1.0 + 0.1 * problem.load) / (width + 10.0)
    steps = gone_back(problem) * work.march_steps
    marched = 7.4e-10 + share * (3.1e-7 / width + 6.8e-8 * listed * steps)
    return 1.5e-4 + work.samples * marched


def _memory_state(work: Work) -> Numbers:
    """Return the time of a steady state of elements with internal variables."""
    faster = 1.0 + FASTER * np.log1p(np.abs(work.problem.speed))
    return faster * (NEWTON + TANGENT * work.units) * sweep_seconds(work.samples)


def _memory_step(work: Work) -> Numbers:
    """Return the time of a step of elements with internal variables.

    Prescribed indentations tell no load: all elements count as moved. With branches alone elements
    are no stiffer than glass.
    """
    problem, whole = work.problem, step_seconds(work.samples)
    if work.scheme != "exponential":
        return (DENSE + UNIT * work.units) * whole
    load = np.where(problem.load, problem.load, np.inf)
    share = touchable_share(problem.hurst, load, viscous_pressure(problem))
    if problem.spectrum.viscosity == 0.0:
        glassy = load / (1.0 + sum(problem.spectrum.moduli))
        share = np.maximum(share, touchable_share(problem.hurst, glassy, NO_PRESSURE))
    share = np.minimum(share + EDGES * work.samples**-0.63, 1.0)
    return ONE_STEP + (LEFT + share * (MOVED + MOVED_UNIT * work.units)) * whole


def touchable_share(hurst: Numbers, load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return the share of the line that is marched: what lies below the indentation.

    At rest it grows with the load; at speed little area carries it, load over viscous pressure.
    Measured on 1500 random problems, Fbar 1e-4 ... 30, vbar 0.02 ... 1000, N 700 ... 12000: half of
    them within 20 %, nine of ten within a factor of 2.2.
    """
    rest = np.exp(-0.40 + 0.78 * hurst) * load**0.635
    speed = np.exp(1.58 + 0.44 * hurst) * (load / viscous_pressure**0.72) ** 1.06
    return (1.0 + rest**-2.8 + speed**-2.8) ** (-1.0 / 2.8)


def partial_contact(load: Numbers, viscous_pressure: Numbers) -> Numbers:
    """Return 1 where part of a line touches and 0 where all of it does, at loads far over 1."""
    return 1.0 / (1.0 + (load / (1.0 + viscous_pressure)) ** 2)


def gone_back(problem: Problem) -> Numbers:
    """Return how much longer marches take that go back to longer lists (kernels/quick/march).

    Near H = 1 and above x = 1e4 most do.
    """
    near_one = 1.0 / (1.0 + np.exp((0.83 - problem.hurst) / 0.03))
    return 1.0 + 1.5 * near_one / (1.0 + (1e4 / speed_ratio(problem)) ** 2)


def followed_patches(problem: Problem) -> Numbers:
    """Return the patches that a steady state follows between the samples, in all turns.

    Under light loads they grow with the load that is carried, under larger ones the line has no
    more of them, and under heavy loads they join each other. Of 6000 random steady states, H 0 to
    1, N 1000 to 50 000, Fbar 2.5e-3 to 25, vbar 0.01 to 1500, each counted as often as it has
    patches, two in three are within a factor of 1.4.
    """
    hurst, elements, load, _, _ = problem[:5]
    pressure = viscous_pressure(problem)
    few = np.exp(1.5 + hurst * (8.1 - 0.97 * np.log(elements))) * load**0.92 * pressure**-1.1
    most = np.exp(-0.27 - 3.9 * hurst) * load**0.54 * speed_ratio(problem) ** 0.18
    joined = np.exp(-0.46 - 2.34 * hurst) * load**-1.17 * pressure**0.83
    return elements / (1.0 / few + 1.0 / most + 1.0 / joined)


# Seconds of one core of the machine of the measurements, busy as it was, for so many samples.
def drawing_seconds(samples: Numbers) -> Numbers:
    """Return the time of drawing a line: phases, two FFTs."""
    return 2.5e-5 + 2.3e-9 * samples**1.22


def sweep_seconds(samples: Numbers) -> Numbers:
    """Return the time of a sweep of a Kelvin element over all samples."""
    return 3.7e-6 + 3.5e-9 * samples


def step_seconds(samples: Numbers) -> Numbers:
    """Return the time of a step of Kelvin elements at all samples."""
    return 1.3e-7 + 3.5e-9 * samples
