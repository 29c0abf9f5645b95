"""Rough core time of a realization: one constant per kind of work.

The constants are CPU times of one core of a server of 2023. Predictions for whole studies are
within a factor of COST_FACTOR of the truth; single problems are further off. A run corrects them by
the rates of its first batches, and `plan --sample` times batches of the study itself. No task key
and no result depends on them.

The functions take a problem or a stack of problems (problems.py), and the steps of each.
"""

import numpy as np

from ...kernels import KELVIN, Quantities
from ..simulate import Problem, Recording, total_steps
from ..study import HALF_SPACE
from .problems import Numbers

COST_FACTOR = 3.0  # the truth lies within this factor of the prediction

DRAWING_SECONDS = 1.5e-8  # per sample of a line or map: random phases and Fourier transforms
CALL_SECONDS = 5e-5  # per task and line: calls from Python
# Kelvin elements. Most samples of a march neither gain nor lose contact, so that its time hardly
# grows with the number of steps (kernels/quick/march).
STATES_SECONDS = 1.2e-8  # per sample: both steady states and the jump
MARCH_SECONDS = 4e-9  # per sample: to sort the samples of a march
LISTED_SECONDS = 1.2e-11  # per sample and step of a march
# Elements with internal variables, and programmes of any elements.
SWEEP_SECONDS = 2e-9  # per sample and turn round the periodic line
SWEEP_TURNS = 10  # to reach a steady state, and one more for each internal variable
STEP_SECONDS = 5e-7  # per step
ELEMENT_SECONDS = 3e-10, 6e-11  # per step and sample; the second for each internal variable
ALL_ELEMENTS = 5.0  # factor on a step that also moves elements that cannot touch
PULLED_STEPS = 2.0  # steps of a line pulled by a spring, per step of its programme
# Maps on a half-space: passes of conjugate gradients.
PASS_SECONDS = 1.5e-8  # per sample
KELVIN_PASSES, BRANCH_PASSES = 800.0, 150.0  # for both steady states
STEP_PASSES, JUMP_PASSES = 4.5, 18.0  # for a step, and for the jump
HOT_SOLUTIONS, HOT_STEP = 3.5, 1.6  # cost with heat over that without: steady sliding, a step
HALVED_STEPS_COST = 4.0  # cost of a repeated run with halved steps, over the first run


def drawing_seconds(samples: Numbers) -> Numbers:
    """Return the predicted time to draw a line or a map. samples : its size."""
    return DRAWING_SECONDS * samples


def realization_seconds(
    problem: Problem,
    steps: Numbers,
    march_steps: Numbers,
    quantities: Quantities,
    recording: Recording,
    scheme: str,
) -> Numbers:
    """Return the predicted time of one realization on a line that is already drawn.

    steps : per spacing. march_steps : after the jump; 0 without a march.
    """
    marched = march_steps + 0.0
    if recording.requested:
        different, inverse = np.unique(steps, return_inverse=True)
        counts = np.array([total_steps(problem, int(m)) for m in different])
        marched = marched + counts[inverse].reshape(np.shape(steps))
    if problem.surface.body == HALF_SPACE:
        return _map_seconds(problem, steps, marched, quantities)
    samples = problem.samples(steps)
    if problem.spectrum == KELVIN and not recording.requested:
        states = quantities.anything * STATES_SECONDS
        march = quantities.relaxation * (MARCH_SECONDS + LISTED_SECONDS * marched)
        return CALL_SECONDS + samples * (states + march)
    return CALL_SECONDS + _memory_seconds(problem, samples, marched, quantities, scheme)


def _memory_seconds(
    problem: Problem, samples: Numbers, marched: Numbers, quantities: Quantities, scheme: str
) -> Numbers:
    """Return the predicted time of elements with internal variables, or of a programme."""
    variables = len(problem.spectrum.moduli) + (problem.spectrum.viscosity > 0.0)
    states = quantities.anything + (quantities.steady or quantities.relaxation)
    states += problem.start == "steady" and bool(problem.programme)
    turns = states * (SWEEP_TURNS + variables)
    element, variable = ELEMENT_SECONDS
    step = STEP_SECONDS + samples * (element + variable * variables)
    if scheme != "exponential":
        step = ALL_ELEMENTS * step
    if problem.drive:
        step = PULLED_STEPS * step
    return turns * SWEEP_SECONDS * samples + marched * step


def _map_seconds(
    problem: Problem, steps: Numbers, marched: Numbers, quantities: Quantities
) -> Numbers:
    """Return the predicted time of a map on a half-space."""
    passes = KELVIN_PASSES if problem.spectrum == KELVIN else BRANCH_PASSES
    step_passes = STEP_PASSES
    if problem.effects.heat:
        passes, step_passes = HOT_SOLUTIONS * passes, HOT_STEP * STEP_PASSES
    passes = quantities.anything * passes + quantities.jump * JUMP_PASSES
    return PASS_SECONDS * problem.samples(steps) * (passes + step_passes * marched)
