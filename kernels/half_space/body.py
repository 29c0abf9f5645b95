"""A viscoelastic half-space and its time steps under a moving surface.

Elements have memory and a law (rheology/law.py). In place of an element's force, the law takes A p,
the displacement of the relaxed body under the pressures p. Pressures are stored at the samples of
the surface, which meets the same elements only once per period. A step is one elastic contact of
the surface z - w with a body K times as stiff as the relaxed one, where w is the displacement of
the body without pressure.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..interface.layer import Layer, compliance_ratio
from ..rheology.law import advance_memory, law_of, predict, rest_memory, static_pressure
from ..rheology.spectrum import KELVIN, Spectrum
from .contact import ElasticContact, Operator, press
from .surface import Surface
from .waves import half_space_stiffness, wave_numbers

# Tolerances of a contact (contact.py), relative to A p. Errors of a step decay in later steps: the
# error of mu is 3e-5 of its maximum, or 3e-6 if each step takes at least one pass.
STEP_TOLERANCE, CONTACT_TOLERANCE = 3e-5, 1e-7
# For Kelvin elements the tolerance is the first number times K, but at most the second: for large K
# pressures have little effect on later steps. The error of mu is then 5e-5 of its maximum.
TOLERANCE_PER_STIFFNESS, MAX_STEP_TOLERANCE = 1.5e-5, 3e-4


class HalfSpace(NamedTuple):
    """Constants of a contact: the material, the surface pressed on it, and the load."""

    form: Any  # form of the material (rheology/forms.py)
    surface: Surface
    operator: Operator  # compliance A of the relaxed body for every mode (contact.py)
    pressure: float  # mean pressure, in E* h/dx
    stepped: bool = False  # whether steady friction is the mean over a step

    @classmethod
    def under(
        cls,
        form: Any,
        surface: Surface,
        load: float,
        stiffness: np.ndarray | None = None,
        layer: Layer | None = None,
    ) -> "HalfSpace":
        """Return a half-space, or a layer on a rigid base, under a load Fbar = F_N/(E* L h).

        stiffness : of every mode of a deep half-space, or None for |q|/2.
        """
        m, shape = surface.steps_per_spacing, surface.z.shape
        if stiffness is None:
            stiffness = half_space_stiffness(shape, m)
        if layer is not None:
            stiffness = stiffness / compliance_ratio(layer, np.hypot(*wave_numbers(shape, m)))
        return cls(form, surface, Operator.of(stiffness, shape[1]), load * m / shape[1])


class Body(NamedTuple):
    """State of a half-space between two steps."""

    memory: np.ndarray  # shape (M, rows n): internal variables of the elements
    depth: np.ndarray  # shape (rows n,): A p of the last step, at the elements, in h
    p: np.ndarray  # shape (rows, n): pressures, at the samples of the surface, in E* h/dx
    d: float  # approach: depth of the mean of the surface below the mean of the body, in h
    offset: int  # position of the surface: sample i - offset (modulo n) lies over element i


class Step(NamedTuple):
    """Constants of steps in which the surface moves by one sample."""

    law: Any  # law of the elastomer in a step (rheology/law.py)
    direction: int  # 1: towards +x, -1: towards -x
    weight: np.ndarray  # shape (rows, n): dz/dx at the instant when the force acts, in h/dx

    @classmethod
    def of(cls, form: Any, surface: Surface, speed: float) -> "Step":
        """Return the Step of sliding at a signed speed vbar."""
        law = law_of(form, 1.0 / (surface.steps_per_spacing * abs(speed)))
        direction = 1 if speed > 0.0 else -1
        earlier = np.roll(surface.slope, -direction, axis=1)
        return cls(law, direction, surface.slope + law.lag * (earlier - surface.slope))


def step_tolerance(spectrum: Spectrum, law: Any) -> float:
    """Return the tolerance of the contacts in a march of a material; law : of its steps."""
    if spectrum != KELVIN:
        return STEP_TOLERANCE
    return min(TOLERANCE_PER_STIFFNESS * law.stiffness, MAX_STEP_TOLERANCE)


def take_step(
    space: HalfSpace, body: Body, step: Step, tolerance: float = STEP_TOLERANCE
) -> tuple[Body, int]:
    """Advance a body by a step of one sample; return (body, passes). Memory changes in place."""
    z = space.surface.z
    offset = (body.offset + step.direction) % z.shape[1]
    w, contact = try_step(space, body, step.law, z, offset, tolerance)
    return body_after(body, step.law, w, contact, offset), contact.passes


def try_step(
    space: HalfSpace, body: Body, law: Any, z: np.ndarray, offset: int, tolerance: float
) -> tuple[np.ndarray, ElasticContact]:
    """Return (displacements without pressure, contact) of a step without changing the body."""
    w, gap = np.empty(body.depth.size), np.empty_like(z)
    open_gap(law, body.memory, body.depth, z, offset, w, gap)
    depth = at_samples(body.depth, body.offset, z.shape)
    start = ElasticContact(body.p, depth, body.d * law.stiffness, 0)
    return w, press(gap, space.pressure, space.operator, start, tolerance)


def body_after(body: Body, law: Any, w: np.ndarray, contact: ElasticContact, offset: int) -> Body:
    """Return the body after an attempted step; memory changes in place."""
    new = at_elements(contact.depth, offset)
    settle_memory(law, body.memory, w, body.depth, new)
    return Body(body.memory, new, contact.p, contact.d / law.stiffness, offset)


@kernel
def open_gap(law, memory, depth, z, offset, w, gap):
    """Fill w with displacements without pressure, and gap with K (z - w) at the samples."""
    predict(law, memory, depth, w)
    rows, n = z.shape
    for y in range(rows):
        for j in range(n - offset):
            gap[y, j] = law.stiffness * (z[y, j] - w[y * n + j + offset])
        for j in range(n - offset, n):
            gap[y, j] = law.stiffness * (z[y, j] - w[y * n + j + offset - n])


def at_elements(values: np.ndarray, offset: int) -> np.ndarray:
    """Return values at the elements, shape (rows n,), from those at the samples (rows, n)."""
    return np.roll(values, offset, axis=1).ravel()


def at_samples(values: np.ndarray, offset: int, shape: tuple[int, int]) -> np.ndarray:
    """Return values at the samples of the surface, from those at the elements."""
    return np.roll(values.reshape(shape), -offset, axis=1)


def rest_on(space: HalfSpace, stiffness: float = 1.0) -> tuple[Body, int]:
    """Return (body in equilibrium with a resting surface, passes).

    stiffness : of the body, over that of the relaxed body.
    """
    gap = stiffness * space.surface.z
    contact = press(gap, space.pressure, space.operator, None, CONTACT_TOLERANCE)
    depth = at_elements(contact.depth, 0)
    memory = rest_memory(space.form, depth / stiffness)
    return Body(memory, depth, contact.p, contact.d / stiffness, 0), contact.passes


@kernel
def settle_memory(law, memory, w, depth, new):
    """Advance the memory of all elements over a step, in place; see ``advance_memory``."""
    advance_memory(law, memory, w, depth, new)


@kernel
def lasting_depth(form, memory):
    """Return (viscosity, part of A p that does not depend on rates)."""
    return static_pressure(form, memory)
