"""General computation of one case: any material, sliding in either direction.

Kelvin elements that only slide in the positive direction are computed faster (cases.py).
"""

import numpy as np

from ..body.patch_width import samples_per_contact
from ..branches.memory_friction import (
    friction_by_loss,
    friction_jump,
    initial_rate,
    step_friction,
)
from ..branches.steady_memory import SteadyMemory, steady_memory
from ..lines.line import Line
from ..motion.legs import Slide
from ..rheology.forms import form_of
from ..rheology.retardation import Retardation
from ..scene import SavedState, SceneCase, run_scene
from .case import FIRST_STEP, JUMP, MARCHING, STEADY, Case, Outcome, PhaseClocks, Quantities


def run_memory_case(line: Line, case: Case, requested: Quantities) -> Outcome:
    """Compute one case on one line; the case has been checked (prepared.py).

    The relaxation curve is mu_2 plus the difference between mu of the march and its step average
    in steady sliding at v2. Without a dashpot mu does not jump, but d mu/dt does. Friction and
    jumps of a stepped case are those of the steps, as in model/realization.py.
    """
    clock, form = PhaseClocks(), form_of(case.spectrum, case.scheme)
    one, mu_1, contact = _steady(line, case, case.speed)
    work = one.work
    clock.lap_phase(STEADY)
    count = len(case.ratios)
    mu_2, jump, rate = np.full(count, np.nan), np.full(count, np.nan), np.full(count, np.nan)
    curves = []
    for k, ratio in enumerate(case.ratios):
        speed = ratio * case.speed
        if requested.jump:
            jump[k] = 0.0  # without a dashpot
            if case.spectrum.viscosity > 0.0 and case.stepped:
                jump[k] = _relaxation(line, case, one, speed, FIRST_STEP)[0] - mu_1
            elif case.spectrum.viscosity > 0.0:
                jump[k] = friction_jump(form, line, one.elements, case.speed, ratio)
        if requested.initial_rate:
            units = _retardation_form(case)
            rate[k] = initial_rate(units, line, one.p, case.speed, ratio) if units.glass else np.nan
        clock.lap_phase(JUMP)
        if not (requested.steady or requested.relaxation):
            continue
        two, mu_2[k], _ = _steady(line, case, speed)
        work += two.work
        clock.lap_phase(STEADY)
        if requested.relaxation:
            curve = _relaxation(line, case, one, speed, case.kept_steps[k])
            curves.append(mu_2[k] + (curve - step_friction(form, line, two.p, speed)))
            work += line.z.size * int(case.kept_steps[k][-1])
            clock.lap_phase(MARCHING)
    depth = one.d + line.datum
    samples = samples_per_contact(one.p)
    return Outcome(mu_1, depth, contact, samples, mu_2, jump, curves, work, clock.seconds(), rate)


def _steady(line: Line, case: Case, speed: float) -> tuple[SteadyMemory, float, float]:
    """Return (steady state, mu, share of samples in contact) at a speed."""
    form = form_of(case.spectrum, case.scheme)
    load = case.load * line.z.size
    state = steady_memory(form, line.z, line.steps_per_spacing * speed, load)
    mu, contact = friction_by_loss(_retardation_form(case), form, line, state.p, speed)
    if case.stepped:
        mu = step_friction(form, line, state.p, speed)
    return state, mu, contact


def _retardation_form(case: Case) -> Retardation:
    """Return the material of a case in retardation form."""
    units = form_of(case.spectrum, "exponential")
    assert isinstance(units, Retardation)
    return units


def _relaxation(
    line: Line, case: Case, one: SteadyMemory, speed: float, kept_steps: np.ndarray
) -> np.ndarray:
    """Return mu at the recorded steps after a jump from steady sliding ``one`` to ``speed``."""
    distance = int(kept_steps[-1]) / line.steps_per_spacing
    scene = SceneCase(
        spectrum=case.spectrum,
        scheme=case.scheme,
        programme=(Slide(speed, distance),),
        load=case.load,
        indentation=None,
        start="steady",
        requested=("trace",),
        recorded=kept_steps,
        edges=np.empty(0),
        frames=np.empty(0, np.int64),
    )
    state = SavedState(*one.elements, 0.0, 0.0, case.speed)
    return run_scene(line, scene, state)["trace_mu"]
