"""The active-set march: like the march of model/march.py, but it steps only undecided samples."""

import numpy as np

from ...compile.jit import kernel
from ..contacts.pressed_samples import pressure_sums
from .bounds import extended_bounds, initial_bounds, spread_bounds
from .certain_landings import no_landings
from .gap_crossings import SteadyFlight, run_entries
from .listed_samples import listed_samples
from .shortened_lists import march_with_shortening
from .step_indentation import predict_first_indentation
from .stepping import ActiveSet, MarchState, Recorder
from .undecided_runs import undecided_runs

BOUND_MARGINS = (0.05, 0.3, 2.0, 2.0)  # relative to the spread of d and D, one per attempt


@kernel
def active_march(problem, control, kept_steps, margins=BOUND_MARGINS):
    """March from steady sliding at v1; return (mu, indentation, settled, work, inside).

    problem : JumpProblem. control : ConstantForce.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are recorded.
    mu, indentation : see model/march.py. settled : mu of steady sliding at v2, averaged over a
    step. work : element updates. inside : whether d and D stayed within the last bounds.
    """
    law, start, end = problem.law, problem.start, problem.end
    recorder = Recorder(kept_steps, np.empty(kept_steps.size), np.empty(kept_steps.size))
    guess = predict_first_indentation(control, problem)
    bounds = initial_bounds(problem, guess, margins[0])
    settled, work, inside, flight = np.nan, 0, False, SteadyFlight(start.decay.sample, start.d)
    state, last = MarchState(0, 0, start.d, guess, np.nan), kept_steps[-1]
    for attempt in range(1, len(margins) + 1):
        runs, collected, sums = undecided_runs(problem, bounds)
        listed = listed_samples(runs, collected)
        depth, moment, _ = pressure_sums(collected.c_end, None, collected.weight, end.d)
        settled = (sums.moment + moment) / (sums.depth + depth)
        entries = run_entries(law, listed, runs, flight, problem.z, last)
        landings = no_landings(end.d, start.d, last)
        active = ActiveSet(runs, listed, sums, entries, landings)
        inside, stop, _, updates = march_with_shortening(
            problem, control, active, bounds, state, last, recorder, 1.0
        )
        work += updates + problem.z.size
        if inside or attempt == len(margins) or not np.isfinite(stop.d):
            break
        visited = extended_bounds(bounds, stop.d, stop.advance)
        bounds = spread_bounds(law, visited, margins[attempt])
    return recorder.mu, recorder.indentation, settled, work, inside
