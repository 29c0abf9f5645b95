"""One case on one surface: steady sliding, velocity jumps and relaxation, as for lines.

Only requested quantities are computed.
"""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.forms import form_of
from ..rheology.retardation import Retardation
from ..rheology.spectrum import Spectrum
from ..velocity_step.case import (
    JUMP,
    MARCHING,
    STEADY,
    Case,
    ContactAreas,
    HotParts,
    Outcome,
    PhaseClocks,
    Quantities,
)
from .body import Body, HalfSpace, Step, step_tolerance, take_step
from .heating import Heating
from .hot_relaxation import hot_relaxation
from .hot_sliding import HotSliding, slide_with_heat
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
    samples_per_contact : mean number of samples in a patch (connected by sides).
    work : samples times passes of the operator. The relaxation curve is mu_2 plus the difference
    between mu of the march and its steady value. The field refine of a case is ignored. Friction
    and jumps of a stepped case are those of the steps.
    stiffness : of every mode, or None for a half-space. Raises ValueError if no steady state is
    found.
    """
    clock = PhaseClocks()
    space = HalfSpace.under(
        form_of(case.spectrum, case.scheme), surface, case.load, stiffness, case.effects.layer
    )._replace(stepped=case.stepped)
    variables = _kept_variables(space, case, requested)
    fastest = max([1.0, *map(abs, case.ratios)]) * abs(case.speed)
    min_step = 1.0 / (surface.steps_per_spacing * fastest)
    heating = Heating.of(space, case.effects, min_step)
    one_hot = slide_with_heat(space, case.spectrum, heating, case.speed, None, variables)
    one = one_hot.sliding
    passes = one.passes
    clock.lap_phase(STEADY)
    count = len(case.ratios)
    jumps, rates, mu_2, final = np.full((4, count), np.nan)
    contact = real_contact(one.body.p, one.viscous)
    hot = _hot_parts(one_hot, heating, count)
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
        if case.stepped and case.spectrum.viscosity > 0.0:
            speeds = np.array(case.ratios) * case.speed * one_hot.slowing
            jumps, used = _jumps_of_first_steps(space, one, speeds.tolist(), case.spectrum)
            passes += used
        if heating:
            speeds = np.array(case.ratios) * case.speed
            hot.jump_shear[:] = _jumps_of_shear(heating, one_hot, speeds, areas.after)
    if requested.initial_rate and case.ratios:
        rates, used = initial_rates(space, case.spectrum, one, case.speed, case.ratios)
        passes += used
    clock.lap_phase(JUMP)
    curves = []
    for k, ratio in enumerate(case.ratios):
        if not (requested.steady or requested.relaxation):
            continue
        two_hot = slide_with_heat(space, case.spectrum, heating, ratio * case.speed, one_hot, 0)
        two, hot.mu_2_shear[k] = two_hot.sliding, two_hot.shear
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
                curve, shear, area, used = hot_relaxation(*march)
                curves.append(curve)
                hot.curve_shear.append(shear)
            areas.curves.append(area)
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
        hot if heating else None,
    )


def _hot_parts(one: HotSliding, heating: Heating | None, count: int) -> HotParts:
    """Return the values of steady sliding at v1, with NaN for those of the velocity jumps."""
    nothing = np.full(count, np.nan)
    if heating is None or one.warmth is None:
        return HotParts(np.nan, np.nan, 0.0, nothing, nothing.copy(), [])
    flash = heating.flash(one.warmth)
    return HotParts(one.warmth.contact, flash, one.shear, nothing, nothing.copy(), [])


def _jumps_of_shear(
    heating: Heating, one: HotSliding, speeds: np.ndarray, areas: np.ndarray
) -> list[float]:
    """Return the jumps of the shear part of mu at constant temperature, in h/dx.

    speeds, areas : just after the velocity jumps.
    """
    assert one.warmth is not None
    contact = one.warmth.contact
    pairs = zip(speeds.tolist(), areas.tolist(), strict=True)
    return [heating.shear(area, speed, contact) - one.shear for speed, area in pairs]


def _jumps_of_first_steps(
    space: HalfSpace, one: SlidingBody, speeds: list[float], spectrum: Spectrum
) -> tuple[np.ndarray, int]:
    """Return (mu of the first step at each speed minus mu_1, passes)."""
    jumps, passes = np.empty(len(speeds)), 0
    for k, speed in enumerate(speeds):
        step = Step.of(space.form, space.surface, speed)
        start = one.body._replace(memory=one.body.memory.copy())
        body, used = take_step(space, start, step, step_tolerance(spectrum, step.law))
        jumps[k], passes = mean_slope(body.p, step.weight) - one.mu, passes + used
    return jumps, passes


def _steady_sums(space: HalfSpace, sliding: SlidingBody, tiles: int) -> list[np.ndarray]:
    """Return the normal force and the dissipated power of tiles (tiles.py)."""
    p = sliding.body.p
    power = quadratic_density(p, space.operator.compliance * sliding.loss)
    return [tile_sums(density, tiles) for density in (p, power)]


def _kept_variables(space: HalfSpace, case: Case, requested: Quantities) -> int | None:
    """Return the number of internal variables that jumps and marches read, or None for all.

    Marches do not read variables that decay below the rounding error in one step.
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

    Both follow from the pressures of a step.
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
