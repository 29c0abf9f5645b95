"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, one steady state at v1 serves all velocity jumps.
"""

import numpy as np

from kernels.active.march import active_march
from kernels.active.setting import Setting
from kernels.case import Case, Clock, Outcome, Quantities, Seconds
from kernels.control.force import ConstantForce
from kernels.control.printed_eq3 import PrintedForce
from kernels.friction import lagged_slope, step_average
from kernels.limits import LOADS, SPEEDS, check_between
from kernels.march import march
from kernels.memory_case import run_memory_case
from kernels.patches.steady_friction import jump as jump_to
from kernels.patches.steady_friction import steady_friction
from kernels.rheology.kelvin import SCHEMES
from kernels.rheology.spectrum import shortest_step
from kernels.surfaces.line import Line

LEAST_STEP = 1e-9  # |r - 1|, or zero; r is then known to 1e-7 of it, the jump to 1e-5


def _check(line: Line, case: Case, asked: Quantities) -> None:
    """Raise ValueError for a case without meaning, or beyond what doubles can resolve."""
    speeds = [abs(speed) for speed in (case.speed, *(r * case.speed for r in case.ratios))]
    check_between("load", case.load, LOADS)
    for speed in speeds:
        check_between("speed", speed, SPEEDS)
    for ratio in case.ratios:
        if 0.0 < abs(ratio - 1.0) < 0.99 * LEAST_STEP:  # or 1e-9 itself would round out of it
            raise ValueError(f"ratio = 1 + {ratio - 1.0:g}: the step is lost in rounding")
    shortest = 1.0 / (line.steps_per_spacing * max(speeds))
    if shortest < shortest_step(case.spectrum):
        raise ValueError(f"speed = {max(speeds):g}: steps of {shortest:g} tau are lost in rounding")
    for kept in case.kept_steps if asked.relaxation else ():
        if not (len(kept) and kept[0] >= 1 and np.all(np.diff(kept) > 0)):
            raise ValueError("kept_steps must hold increasing step numbers from 1 on")


def run_case(line: Line, case: Case, asked: Quantities) -> Outcome:
    """Compute one case on one line.

    The relaxation curve is mu_2 plus the deviation of the marched step average from its own
    steady value, so that it ends at mu_2 exactly whatever the step. Raises ValueError for a
    case that is not supported.
    """
    _check(line, case, asked)
    if not case.plain:
        return run_memory_case(line, case, asked)
    load = case.load * line.z.size
    clock = Clock()
    one = steady_friction(line, case.speed, case.scheme, load)
    clock.lap("steady")
    work = one.updates
    mu_2 = np.full(len(case.ratios), np.nan)
    jump = np.full(len(case.ratios), np.nan)
    curves = []
    for k, ratio in enumerate(case.ratios):
        speed = ratio * case.speed
        if asked.jump:
            jump[k] = jump_to(one, speed)
            clock.lap("jump")
        if not (asked.steady or asked.relaxation):
            continue
        two = one if ratio == 1.0 else steady_friction(line, speed, case.scheme, load)
        mu_2[k] = two.mu
        work += two.updates if ratio != 1.0 else 0
        clock.lap("steady")
        if asked.relaxation:
            control = (ConstantForce if asked.indentation_rate else PrintedForce)(load)
            before, after = (
                SCHEMES[case.scheme](1.0 / (line.steps_per_spacing * v))
                for v in (case.speed, speed)
            )
            setting = Setting(line.z, line.slope, before, after, one.state, two.state)
            curve, updates = _relaxation(setting, control, case.kept_steps[k])
            curves.append(mu_2[k] + curve)
            work += updates
            clock.lap("marching")
    seconds = Seconds(**clock.spent)
    samples = one.samples if asked.relaxation else one.seen.samples
    means = one.mu, one.indentation, one.contact, samples
    rate = np.full(len(case.ratios), np.nan)
    return Outcome(*means, mu_2, jump, curves, work, seconds, rate)


def _relaxation(
    setting: Setting, control: ConstantForce | PrintedForce, kept_steps: np.ndarray
) -> tuple[np.ndarray, int]:
    """Return the deviation from the steady friction at v2, and the element updates."""
    mu, _, settled, work, inside = active_march(setting, control, kept_steps)
    if inside:
        return mu - settled, work
    z, slope, _, law, one, two = setting
    weight = lagged_slope(slope, law.lag)
    # d stays between its steady values but for a transient. It never exceeds what one element
    # needs: the deepest sample gives d_new <= E d_old + load / K, and K (1 - E) = 1.
    for cap in (1.02 * max(one.d, two.d), 1.001 * max(one.d, control.load)):
        mu, _, passes, inside = march(law, control, z, weight, one, kept_steps, cap)
        work += passes * z.size
        if inside:
            break
    return mu - step_average(weight, z - two.w, two.d), work
