"""A line of elements of any material that steps every element: the reference of quick/blocks."""

from typing import Any, NamedTuple

import numpy as np

from ..model.balance import balance
from ..model.friction import weighted_sums
from ..rheology.law import Elements, advance_memory, predict
from .force_means import mean_forces
from .ground import fill_heights, fill_slopes
from .patch_width import median_patch_width
from .step import accept, attempt, elements_of, end_leg, forces, on_ground, patch_width


class ElementLine(NamedTuple):
    """Elements under a line; the arrays of elements are changed in place."""

    form: Any  # of the material (rheology/forms.py)
    control: Any  # determines the indentation (model/balance.py)
    ground: Any  # the line over them (ground.py)
    memory: np.ndarray  # shape (M, n)
    p: np.ndarray  # shape (n,): forces of the last accepted step, in 4 G dx h
    new: np.ndarray  # shape (n,): forces of the attempted step
    w: np.ndarray  # shape (n,): displacements without force in it
    z: np.ndarray  # shape (n,): heights of the line at its end, then slopes
    c: np.ndarray  # shape (n,): contact thresholds z - w, then workspace
    load_of_width: np.ndarray  # shape (n,): workspace of median_patch_width


class LineState(NamedTuple):
    """State of an ElementLine besides its arrays."""

    old_d: float  # indentation before the last accepted step, in h
    d: float  # after it
    attempted_d: float  # after the step that was attempted last
    passes: int  # over the thresholds, in all attempts


def element_line(
    form: Any, control: Any, ground: Any, elements: Elements
) -> tuple[ElementLine, LineState]:
    """Return (ElementLine, LineState) of elements before their first step on a ground."""
    memory, p, d = elements
    room = [np.zeros_like(p) for _ in range(5)]
    return ElementLine(form, control, ground, memory.copy(), p.copy(), *room), LineState(d, d, d, 0)


@on_ground.register(ElementLine)
def _on_ground(body, state, ground):
    return body._replace(ground=ground), state


@attempt.register(ElementLine)
def _attempt(body, state, law, step):
    new, w, z, c = body.new, body.w, body.z, body.c
    fill_heights(body.ground, step.after, 0, z)
    predict(law, body.memory, body.p, w)
    for i in range(c.size):
        c[i] = z[i] - w[i]
    d, passes = balance(body.control, law, z, c, None, state.d, step.number)
    for i in range(c.size):
        depth = d - c[i]
        new[i] = law.stiffness * depth if depth > 0.0 else 0.0
    return LineState(state.old_d, state.d, d, state.passes + passes)


@forces.register(ElementLine)
def _forces(body, state, law, step):
    c, slope, n = body.c, body.z, body.c.size
    fill_slopes(body.ground, step, law.lag, 0, n, slope)
    for i in range(n):
        c[i] = -body.new[i]
    return mean_forces(weighted_sums(c, None, slope, 0.0), n)


@accept.register(ElementLine)
def _accept(body, state, law):
    advance_memory(law, body.memory, body.w, body.p, body.new)
    for i in range(body.p.size):
        body.p[i] = body.new[i]
    return LineState(state.d, state.attempted_d, state.attempted_d, state.passes)


@end_leg.register(ElementLine)
def _end_leg(body, state):
    return state


@patch_width.register(ElementLine)
def _patch_width(body, state):
    return median_patch_width(body.p, body.load_of_width)


@elements_of.register(ElementLine)
def _elements_of(body, state):
    return Elements(body.memory.copy(), body.p.copy(), state.d)
