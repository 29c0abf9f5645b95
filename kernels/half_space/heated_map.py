"""A map on a half-space that its own friction heats: a body around a MovedMap (body/step.py).

The law of a step is that of its duration over a_T at its temperature (heating.py), so that drivers
get a law whose lag is known after the attempt.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ..body.step import Forces, accept, attempt, end_leg, forces, patch_width
from ..rheology.law import law_of
from .body import Body
from .heating import Heating, SlidingContact, Warmth, heated_step
from .moved_map import MapState, MovedMap
from .patches import samples_per_patch


class HeatedForm(NamedTuple):
    """Form of a material whose law depends on the temperature of a step."""

    form: Any


class HeatedLaw:
    """Law of a step that was attempted at a temperature of its own."""

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
    recorded: frozenset[int] | None  # numbers of the steps whose temperatures are kept; None: all
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


class HeatedState(NamedTuple):
    """State of a HeatedMap."""

    moved: MapState  # with an attempted contact, if any
    warmth: Warmth  # after the last accepted step
    time: float  # at its end, in tau
    acting: Forces | None = None  # in the attempted step
    attempted: Warmth | None = None
    temperature: float = math.nan  # in the attempted step, °C
    number: int = 0  # of the attempted step

    @property
    def old_d(self) -> float:
        """Return the approach before the last accepted step, in h."""
        return self.moved.old_d

    @property
    def d(self) -> float:
        """Return the approach after it, in h."""
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
    moved: MovedMap, state: MapState, heating: Heating, warmth: Warmth, recorded: Any
) -> tuple[HeatedMap, HeatedState]:
    """Return (body, state) of a map before its first step; the rest as in HeatedMap."""
    kept = [(0.0, warmth.contact, heating.flash(warmth))]
    return HeatedMap(moved, heating, recorded, kept), HeatedState(state, warmth, 0.0)


@attempt.register(HeatedMap)
def _attempt(body, state, law, step):
    before, after = (body.moved.position(place) for place in (step.before, step.after))
    passes = state.moved.passes

    def attempt_at(duration: float, temperature: float) -> SlidingContact:
        nonlocal passes
        law.law = law_of(body.moved.form, duration)
        attempted = attempt(body.moved, state.moved._replace(passes=passes), law.law, step)
        passes = attempted.passes
        acting = forces(body.moved, attempted, law.law, step)
        p, fraction = attempted.attempted.contact.p, after - math.floor(after)
        return SlidingContact((attempted, acting), p, acting.mu, after - before, fraction)

    sliding, warmth, temperature = heated_step(body.heating, state.warmth, law.dt, attempt_at)
    moved, acting = sliding.result
    return HeatedState(moved, state.warmth, state.time, acting, warmth, temperature, step.number)


@forces.register(HeatedMap)
def _forces(body, state, law, step):
    return state.acting


@accept.register(HeatedMap)
def _accept(body, state, law):
    if body.recorded is None or state.number in body.recorded:
        acted = state.time + (1.0 - law.lag) * law.dt
        body.kept.append((acted, state.temperature, body.heating.flash(state.attempted)))
    moved = accept(body.moved, state.moved, law.law)
    return HeatedState(moved, state.attempted, state.time + law.dt)


@end_leg.register(HeatedMap)
def _end_leg(body, state):
    return state


@patch_width.register(HeatedMap)
def _patch_width(body, state):
    return samples_per_patch(state.body.p)
