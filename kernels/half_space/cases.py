"""One case on one surface: steady sliding, velocity jumps and relaxation, as for lines.

Only requested quantities are computed.
"""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.forms import form_of
from ..rheology.retardation import Retardation
from ..velocity_step.case import (
    JUMP,
    MARCHING,
    STEADY,
    Case,
    ContactAreas,
    Outcome,
    PhaseClocks,
    Quantities,
)
from .body import Body, HalfSpace, Step, step_tolerance, take_step
from .heating import Heating
from .hot_relaxation import hot_relaxation
from .hot_sliding import slide_with_heat
from .instant import friction_jumps, initial_rates
from .patches import real_contact, samples_per_patch
from .sliding_body import SlidingBody
from .surface import Surface
from .tiles import TILE_SUMS, quadratic_density, tile_sums

MIN_KEPT_DECAY = 1e-17  # factor of an internal variable in a step, below the rounding error


def run_case(
    surface: Surface, case: Case, requested: Quantities, stiffness: np.ndarray | None = None
) -> Outcome:
    """Compute one case on one surface; loads Fbar = F_N/(E* L h), speeds of either sign.

    contact_fraction : real contact area, corrected for the samples at edges (patches.py).
    samples_per_contact : mean number of samples in a patch, which is connected by sides.
    work : samples times passes of the operator. The relaxation curve is mu_2 plus the difference
    between mu of the march and its steady value. The field refine of a case is ignored.
    stiffness : of every mode, or None for a half-space. Raises ValueError if no steady state is
    found.
    """
    clock = PhaseClocks()
    space = HalfSpace.under(
        form_of(case.spectrum, case.scheme), surface, case.load, stiffness, case.effects.layer
    )
    variables = _kept_variables(space, case, requested)
    heating = _heating(space, case)
    one_hot = slide_with_heat(space, case.spectrum, heating, case.speed, None, variables)
    one = one_hot.sliding
    passes = one.passes
    clock.lap_phase(STEADY)
    count = len(case.ratios)
    jumps, rates, mu_2, final = np.full((4, count), np.nan)
    contact = real_contact(one.body.p, one.viscous)
    areas = ContactAreas(contact, np.full(count, contact), final, [])
    sums = np.full((count, len(TILE_SUMS), case.tiles, case.tiles), np.nan)
    if case.tiles:
        sums[:, 0] = tile_sums(one.body.p > 0.0, case.tiles)
        sums[:, 1:3] = _steady_sums(space, one, case.tiles)
    if requested.jump and case.ratios:
        jumps, grown, used, sums[:, 6] = friction_jumps(
            space, case.spectrum, one, case.speed * one_hot.slowing, case.ratios, case.tiles
        )
        areas, passes = areas._replace(after=contact + grown), passes + used
    if requested.initial_rate and case.ratios:
        rates, used = initial_rates(space, case.spectrum, one, case.speed, case.ratios)
        passes += used
    clock.lap_phase(JUMP)
    curves = []
    for k, ratio in enumerate(case.ratios):
        if not (requested.steady or requested.relaxation):
            continue
        two_hot = slide_with_heat(space, case.spectrum, heating, ratio * case.speed, one_hot, 0)
        two = two_hot.sliding
        passes, mu_2[k] = passes + two.passes, two.mu
        final[k] = real_contact(two.body.p, two.viscous)
        if case.tiles:
            sums[k, 3] = tile_sums(two.body.p > 0.0, case.tiles)
            sums[k, 4:6] = _steady_sums(space, two, case.tiles)
        clock.lap_phase(STEADY)
        if requested.relaxation:
            if heating is None:
                curve, area, used = _relaxation(space, case, one.body, two, case.kept_steps[k])
                curves.append(two.mu + (curve - two.step_mu))
                areas.curves.append(area)
            else:
                ends, speed = (one_hot, two_hot), ratio * case.speed
                march = space, case.spectrum, heating, ends, speed, case.kept_steps[k]
                curve, used = hot_relaxation(*march)
                curves.append(curve)
            passes += used
            clock.lap_phase(MARCHING)
    return Outcome(
        one.mu,
        one.body.d,
        contact,
        samples_per_patch(one.body.p),
        mu_2,
        jumps,
        curves,
        passes * surface.z.size,
        clock.seconds(),
        rates,
        sums if case.tiles else None,
        areas if requested.areas else None,
    )


def _heating(space: HalfSpace, case: Case) -> Heating | None:
    """Return the heating of a case, which resolves its shortest steps, or None without heat."""
    if case.effects.heat is None:
        return None
    fastest = max(1.0, *map(abs, case.ratios)) * abs(case.speed)
    min_step = 1.0 / (space.surface.steps_per_spacing * fastest)
    return Heating.of(space, case.effects.heat, min_step)


def _steady_sums(space: HalfSpace, sliding: SlidingBody, tiles: int) -> list[np.ndarray]:
    """Return the normal force and the dissipated power of tiles (tiles.py)."""
    p = sliding.body.p
    power = quadratic_density(p, space.operator.compliance * sliding.loss)
    return [tile_sums(density, tiles) for density in (p, power)]


def _kept_variables(space: HalfSpace, case: Case, requested: Quantities) -> int | None:
    """Return the number of internal variables that jumps and marches read, or None for all.

    Marches do not read those which decay to less than the rounding error in every step.
    """
    if case.spectrum.viscosity > 0.0 or not isinstance(space.form, Retardation):
        return None
    if not (requested.relaxation and case.ratios):
        return 0
    fastest = max(case.ratios, key=abs) * case.speed
    decay = Step.of(space.form, space.surface, fastest).law.decay
    return max(1, int(np.count_nonzero(decay > MIN_KEPT_DECAY)))


def _relaxation(
    space: HalfSpace, case: Case, start: Body, two: SlidingBody, numbers: np.ndarray
) -> tuple[np.ndarray, np.ndarray, int]:
    """Return (mu, real contact at the given steps after the jump to the speed of ``two``, passes).

    The force and the contact of a step are those of its pressures.
    """
    body, passes = start._replace(memory=start.memory.copy()), 0
    (mu, areas), at = np.empty((2, numbers.size)), 0
    tolerance = step_tolerance(case.spectrum, two.step.law)
    for number in range(1, int(numbers[-1]) + 1):
        body, used = take_step(space, body, two.step, tolerance)
        passes += used
        if number == numbers[at]:
            mu[at] = mean_slope(body.p, two.step.weight)
            areas[at] = real_contact(body.p, two.viscous)
            at += 1
    return mu, areas, passes
