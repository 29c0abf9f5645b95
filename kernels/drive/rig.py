"""What is pulled: elements under a surface, and a step of them that is tried before it is taken.

A rig is a line here, whose elements are all stepped; one in block_rig.py, of whose elements those
alone are that can touch; or a map in half_space/pulled_map.py. The functions declared here are
reached by its type.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type, kernel
from ..model.balance import balance
from ..model.friction import weighted_sums
from ..rheology.law import Elements, advance_memory, law_of, predict
from ..scene.samples import samples_per_contact
from .posed_line import PosedLine, heights_at, seen_from, slope_at


@dispatch_on_type
def attempt(rig, places, dt):
    """Return (friction, lag) of a step between two Places; the rig keeps what is found.

    friction : F_x in the units of the drive (spring.py). lag : where within the step it acts,
    before its end, as a share of it.
    """


@dispatch_on_type
def accept(rig, dt):
    """Take the step that was tried last; return (normal force, indentation, share in contact).

    The indentation is that at which the force acts, in h; the normal force is in 4 G L h, or in
    E* L h of a half-space.
    """


@dispatch_on_type
def patch_width(rig):
    """Return how many samples a patch of contact had in the step that was taken last."""


class Rig(NamedTuple):
    """A line on its elements; its arrays are changed in place."""

    form: Any  # of the material (rheology/forms.py)
    control: Any  # what the indentation follows from (model/balance.py)
    line: PosedLine
    memory: np.ndarray  # shape (M, n): of the elements
    p: np.ndarray  # shape (n,): forces of the last step, in 4 G dx h
    w: np.ndarray  # shape (n,): where elements would go in the step that is tried
    new: np.ndarray  # shape (n,): forces in it
    d: np.ndarray  # shape (2,): indentation after the last step, and in that which is tried
    sums: np.ndarray  # shape (2,): of forces in that, and of elements that touch


def plain_rig(form: Any, control: Any, line: PosedLine, elements: Elements) -> Rig:
    """Return a rig of elements that have taken no step, of any material."""
    memory, p, d = elements
    room = np.empty_like(p), np.empty_like(p), np.full(2, d), np.empty(2)
    return Rig(form, control, line, memory.copy(), p.copy(), *room)


@attempt.register(Rig)
def _attempt(rig, places, dt):
    law, n = law_of(rig.form, dt), rig.p.size
    z = np.empty(n)
    heights_at(rig.line, *seen_from(rig.line, places.after), z)
    predict(law, rig.memory, rig.p, rig.w)
    c = z - rig.w
    rig.d[1] = balance(rig.control, law, z, c, None, rig.d[0], 0)[0]
    for i in range(n):
        depth = rig.d[1] - c[i]
        rig.new[i] = law.stiffness * depth if depth > 0.0 else 0.0
    some = np.flatnonzero(rig.new)
    return friction_of(rig, places, law.lag, some, rig.new[some]), law.lag


@kernel
def friction_of(rig, places, lag, some, p):
    """Return the friction of a step between two places (eq. 5), and note the other sums.

    some : elements that touch, p : their forces. lag : where within the step they act.
    """
    line, n = rig.line, rig.line.polynomials.shape[1] // 2
    (before, s), (after, t) = seen_from(line, places.before), seen_from(line, places.after)
    slope = np.empty(some.size)
    for j in range(some.size):
        slope[j] = slope_at(line, after + some[j], t)
        if lag > 0.0:
            slope[j] += lag * (slope_at(line, before + some[j], s) - slope[j])
    rig.sums[0], friction, rig.sums[1] = weighted_sums(-p, None, slope, 0.0)
    return friction / n


@accept.register(Rig)
def _accept(rig, dt):
    law = law_of(rig.form, dt)
    advance_memory(law, rig.memory, rig.w, rig.p, rig.new)
    rig.p[:] = rig.new
    d = rig.d[1] + law.lag * (rig.d[0] - rig.d[1])
    rig.d[0] = rig.d[1]
    return rig.sums[0] / rig.p.size, d, rig.sums[1] / rig.p.size


@patch_width.register(Rig)
def _patch_width(rig):
    return samples_per_contact(rig.p)
