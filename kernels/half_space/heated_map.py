"""A map on a half-space heated by friction: a body around a MovedMap (body/step.py).

A step uses the law of its duration over a_T at its temperature (heating.py). The lag of the law is
therefore known only after the attempt.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ..body.step import Forces, accept, attempt, end_leg, forces, patch_width
from ..drive.sticking import static_force
from ..rheology.law import MIN_MAGNITUDE, law_of
from ..rheology.time_shift import ZERO_CELSIUS
from .body import Body
from .heating import (
    DRIVE_TEMPERATURE_TOLERANCE,
    TEMPERATURE_TOLERANCE,
    Heating,
    SlidingContact,
    Warmth,
    heated_step,
)
from .moved_map import MapState, MovedMap
from .patches import samples_per_patch
from .shear_force import static_shear, with_shear_share


class HeatedForm(NamedTuple):
    """Form of a material whose law depends on the temperature of a step."""

    form: Any


class HeatedLaw:
    """Law of a step, set by each attempt at a temperature."""

    def __init__(self, dt: float) -> None:
        self.dt = dt  # in tau
        self.law: Any = None  # of the last attempt

    @property
    def lag(self) -> float:
        """Return the lag of the last attempt (rheology/law.py)."""
        return float(self.law.lag)


@law_of.register(HeatedForm)
def _heated_law(form, dt):
    return HeatedLaw(dt)


class HeatedMap(NamedTuple):
    """A MovedMap and its heating, with the temperatures of its accepted steps."""

    moved: MovedMap
    heating: Heating
    recorded: frozenset[int] | None  # steps whose temperatures are kept; None: all, for a drive
    kept: list[tuple[float, float, float]]  # time (tau), contact and flash temperature (°C)

    @property
    def form(self) -> HeatedForm:
        """Return the form of the material."""
        return HeatedForm(self.moved.form)

    def traces(self, times: np.ndarray) -> dict[str, np.ndarray]:
        """Return the recorded temperatures at the times of a trace, by name."""
        known, *temperatures = np.transpose(self.kept)
        return {
            name: np.interp(times, known, values)
            for name, values in zip(TEMPERATURE_TRACES, temperatures, strict=True)
        }


TEMPERATURE_TRACES = ("trace_contact_temperature", "trace_flash_temperature")


class HeatedAttempt(NamedTuple):
    """Step of a HeatedMap that is not accepted yet."""

    acting: Forces  # with the shear
    warmth: Warmth  # after the step
    temperature: float  # in the step, °C
    direction: float  # of this motion, or of the last one at rest
    number: int  # of the step


class HeatedState(NamedTuple):
    """State of a HeatedMap."""

    moved: MapState  # with the attempted contact, if any
    warmth: Warmth  # after the last accepted step
    time: float  # at its end, in tau
    direction: float  # of the last motion: 1, -1, or 0 before the first
    attempted: HeatedAttempt | None = None

    @property
    def old_d(self) -> float:
        """Return the approach before the last accepted step, in h."""
        return self.moved.old_d

    @property
    def d(self) -> float:
        """Return the approach after the last accepted step, in h."""
        return self.moved.d

    @property
    def passes(self) -> int:
        """Return the passes of the operator, in total."""
        return self.moved.passes

    @property
    def body(self) -> Body:
        """Return the half-space after the last accepted step."""
        return self.moved.body


def heated_map(
    moved: MovedMap,
    state: MapState,
    heating: Heating,
    warmth: Warmth,
    direction: float,
    recorded: frozenset[int] | None,
) -> tuple[HeatedMap, HeatedState]:
    """Return (body, state) of a map before its first step; recorded : as in HeatedMap."""
    kept = [(0.0, warmth.contact, heating.flash(warmth))]
    return HeatedMap(moved, heating, recorded, kept), HeatedState(state, warmth, 0.0, direction)


@attempt.register(HeatedMap)
def _attempt(body, state, law, step):
    before, after = (body.moved.position(place) for place in (step.before, step.after))
    passes, speed = state.moved.passes, (after - before) / body.heating.steps_per_spacing / law.dt
    direction = float(np.sign(speed)) or (0.0 if body.recorded is None else state.direction)
    at_rest = direction * MIN_MAGNITUDE  # the shear at rest has the direction of the last motion

    def attempt_at(duration: float, temperature: float) -> SlidingContact:
        nonlocal passes
        law.law = law_of(body.moved.form, duration)
        attempted = attempt(body.moved, state.moved._replace(passes=passes), law.law, step)
        passes = attempted.passes
        acting, shear = forces(body.moved, attempted, law.law, step), 0.0
        if body.heating.law is not None:
            shear = body.heating.shear(acting.contact_fraction, speed or at_rest, temperature)
        p, moved = attempted.attempted.contact.p, after - before
        result = attempted, with_shear_share(acting, shear)
        return SlidingContact(result, p, acting.mu + shear, moved, after - math.floor(after))

    tolerance = DRIVE_TEMPERATURE_TOLERANCE if body.recorded is None else TEMPERATURE_TOLERANCE
    sliding, warmth, temperature = heated_step(
        body.heating, state.warmth, law.dt, attempt_at, tolerance
    )
    moved, acting = sliding.result
    attempted = HeatedAttempt(acting, warmth, temperature, direction, step.number)
    return state._replace(moved=moved, attempted=attempted)


@forces.register(HeatedMap)
def _forces(body, state, law, step):
    return state.attempted.acting


@static_force.register(HeatedMap)
def _static_force(body, state, acting):
    law, side = body.heating.law, body.moved.side
    kelvin = state.attempted.temperature + ZERO_CELSIUS
    return 0.0 if law is None else static_shear(acting, law, side, kelvin)


@accept.register(HeatedMap)
def _accept(body, state, law):
    _, warmth, temperature, direction, number = state.attempted
    if body.recorded is None or number in body.recorded:
        acted = state.time + (1.0 - law.lag) * law.dt
        body.kept.append((acted, temperature, body.heating.flash(warmth)))
    moved = accept(body.moved, state.moved, law.law)
    return HeatedState(moved, warmth, state.time + law.dt, direction)


@end_leg.register(HeatedMap)
def _end_leg(body, state):
    return state


@patch_width.register(HeatedMap)
def _patch_width(body, state):
    return samples_per_patch(state.body.p)
