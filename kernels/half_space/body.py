"""A half-space that remembers, and one step of it under a surface that moves by one sample.

Memory and laws belong to the elements (rheology/law.py), with A p in the place of an element's
force: the displacement that the pressures would make of the relaxed body. Pressures belong to
the surface, which touches the same elements again only after a period. A step is one elastic
contact of the surface z - w with a body 1/K as compliant as the relaxed one, w being where the
body would go without pressure.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import advance_memory, law_of, predict, rest_memory, static_pressure
from ..rheology.spectrum import KELVIN, Spectrum
from .contact import ElasticContact, Operator, press
from .surface import Surface
from .waves import half_space_stiffness

# Of a contact (contact.py), relative to what the pressures displace. Steps forget what those before
# them left: mu comes out to 3e-5 of its largest, and to 3e-6 where a step takes passes at all.
STEP_TOLERANCE, TOLERANCE = 3e-5, 1e-7
# Of Kelvin elements the tolerance is K times the one, and the other at most: the larger K is, the
# less of a pressure lasts beyond its step. mu then comes out to 5e-5 of its largest.
OF_STIFFNESS, MOST_TOLERANCE = 1.5e-5, 3e-4


class HalfSpace(NamedTuple):
    """A material, the surface that is pressed on it, and what does not change meanwhile."""

    form: Any  # of the material (rheology/forms.py)
    surface: Surface
    operator: Operator  # of the relaxed body: A over the modes (contact.py)
    pressure: float  # mean, in E* h/dx

    @classmethod
    def under(
        cls, form: Any, surface: Surface, load: float, stiffness: np.ndarray | None = None
    ) -> "HalfSpace":
        """Return a half-space under a load Fbar = F_N/(E* L h).

        stiffness : over the modes, where it is not the |q|/2 of a half-space.
        """
        m, shape = surface.steps_per_spacing, surface.z.shape
        if stiffness is None:
            stiffness = half_space_stiffness(shape, m)
        return cls(form, surface, Operator.of(stiffness, shape[1]), load * m / shape[1])


class Body(NamedTuple):
    """What a half-space remembers from one step to the next."""

    memory: np.ndarray  # shape (M, rows n): internal variables of the elements
    depth: np.ndarray  # shape (rows n,): A p of the last step at the elements, in h
    p: np.ndarray  # shape (rows, n): its pressures, at the samples of the surface, in E* h/dx
    d: float  # approach: height of the mean of the surface under the mean of the body, in h
    offset: int  # of the surface: over element i lies sample i - offset, modulo n


class Step(NamedTuple):
    """What is the same in all steps of a march: the surface moves by one sample, either way."""

    law: Any  # of the elastomer in a step (rheology)
    way: int  # 1: towards +x, -1: towards -x
    weight: np.ndarray  # shape (rows, n): dz/dx where the step's force acts, in h/dx

    @classmethod
    def of(cls, form: Any, surface: Surface, speed: float) -> "Step":
        """Return the step of sliding at a signed speed, vbar."""
        law = law_of(form, 1.0 / (surface.steps_per_spacing * abs(speed)))
        way = 1 if speed > 0.0 else -1
        earlier = np.roll(surface.slope, -way, axis=1)
        return cls(law, way, surface.slope + law.lag * (earlier - surface.slope))


def step_tolerance(spectrum: Spectrum, law: Any) -> float:
    """Return how closely a march solves the contact of a step of a law of this material."""
    if spectrum != KELVIN:
        return STEP_TOLERANCE
    return min(OF_STIFFNESS * law.stiffness, MOST_TOLERANCE)


def take_step(
    space: HalfSpace, body: Body, step: Step, tolerance: float = STEP_TOLERANCE
) -> tuple[Body, int]:
    """Take a body over a step of one sample, its memory in place; return it and the passes."""
    z = space.surface.z
    return move_on(space, body, step.law, z, (body.offset + step.way) % z.shape[1], tolerance)


def move_on(
    space: HalfSpace,
    body: Body,
    law: Any,
    z: np.ndarray,
    offset: int,
    tolerance: float = STEP_TOLERANCE,
) -> tuple[Body, int]:
    """Take a body over a step of a law, its memory in place; z, offset : surface at its end."""
    w, found = tried(space, body, law, z, offset, tolerance)
    return settled_on(body, law, w, found, offset), found.passes


def tried(
    space: HalfSpace, body: Body, law: Any, z: np.ndarray, offset: int, tolerance: float
) -> tuple[np.ndarray, ElasticContact]:
    """Return (where the body would go without pressure, contact) of a step as move_on takes it."""
    w, gap = np.empty(body.depth.size), np.empty_like(z)
    open_gap(law, body.memory, body.depth, z, offset, w, gap)
    depth = at_samples(body.depth, body.offset, z.shape)
    start = ElasticContact(body.p, depth, body.d * law.stiffness, 0)
    return w, press(gap, space.pressure, space.operator, start, tolerance)


def settled_on(body: Body, law: Any, w: np.ndarray, found: ElasticContact, offset: int) -> Body:
    """Return the body after a step that was tried, its memory in place."""
    new = at_elements(found.depth, offset)
    take(law, body.memory, w, body.depth, new)
    return Body(body.memory, new, found.p, found.d / law.stiffness, offset)


@kernel
def open_gap(law, memory, depth, z, offset, w, gap):
    """Fill w, and the gap K (z - w) at the samples of the surface."""
    predict(law, memory, depth, w)
    rows, n = z.shape
    for y in range(rows):
        for i in range(n):
            j = i - offset if i >= offset else i - offset + n
            gap[y, j] = law.stiffness * (z[y, j] - w[y * n + i])


def at_elements(values: np.ndarray, offset: int) -> np.ndarray:
    """Return values at the samples of the surface, shape (rows, n), element by element."""
    return np.roll(values, offset, axis=1).ravel()


def at_samples(values: np.ndarray, offset: int, shape: tuple[int, int]) -> np.ndarray:
    """Return values of the elements at the samples of the surface."""
    return np.roll(values.reshape(shape), -offset, axis=1)


def rest_on(space: HalfSpace, stiffness: float = 1.0) -> tuple[Body, int]:
    """Return the body on which the surface has rested, and the passes.

    stiffness : of the body, over that of the relaxed one.
    """
    found = press(stiffness * space.surface.z, space.pressure, space.operator, None, TOLERANCE)
    depth = at_elements(found.depth, 0)
    memory = rest_memory(space.form, depth / stiffness)
    return Body(memory, depth, found.p, found.d / stiffness, 0), found.passes


@kernel
def take(law, memory, w, depth, new):
    """Settle the memory."""
    advance_memory(law, memory, w, depth, new)


@kernel
def lasting_depth(form, memory):
    """Return (viscosity, A p without the dashpot's part at no rate)."""
    return static_pressure(form, memory)
