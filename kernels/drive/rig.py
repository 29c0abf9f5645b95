"""Rigs: elements under a pulled surface, whose steps are tried before they are accepted.

A Rig steps all elements of a line, a BlockRig (block_rig.py) only the elements that can touch, and
a MapRig (half_space/pulled_map.py) a half-space. The functions declared here dispatch on the type
of the rig.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type, kernel
from ..model.balance import balance
from ..model.friction import weighted_sums
from ..rheology.law import Elements, advance_memory, law_of, predict
from ..scene.samples import samples_per_contact
from .shiftable_line import ShiftableLine, heights_at, interval_at, slope_at


@dispatch_on_type
def attempt(rig, places, dt):
    """Try a step between two Places and return its (friction, lag); the rig stores the step.

    friction : F_x in the units of the drive (spring.py). lag : time from the instant at which the
    friction acts to the end of the step, as a fraction of dt.
    """


@dispatch_on_type
def accept(rig, dt):
    """Accept the last tried step; return (normal force, indentation, contact fraction).

    The indentation is taken at the instant at which the force acts, in h. The normal force is in
    4 G L h, or in E* L h for a half-space.
    """


@dispatch_on_type
def patch_width(rig):
    """Return the number of samples per contact patch in the last accepted step."""


# State of a rig: one record, changed in place.
RIG_STATE = np.dtype(
    [
        ("d", np.float64),  # indentation after the last accepted step, in h
        ("trial_d", np.float64),  # indentation after the tried step, in h
        ("normal_sum", np.float64),  # sum of normal forces in the tried step
        ("touching_sum", np.float64),  # number of touching elements in the tried step
    ]
)


class Rig(NamedTuple):
    """A line on its elements; the arrays are changed in place."""

    form: Any  # form of the material (rheology/forms.py)
    control: Any  # determines the indentation (model/balance.py)
    line: ShiftableLine
    memory: np.ndarray  # shape (M, n): internal variables of the elements
    p: np.ndarray  # shape (n,): forces of the last accepted step, in 4 G dx h
    w: np.ndarray  # shape (n,): displacements without force in the tried step, in h
    new: np.ndarray  # shape (n,): forces in the tried step
    state: np.ndarray  # RIG_STATE, shape (1,)


def plain_rig(form: Any, control: Any, line: ShiftableLine, elements: Elements) -> Rig:
    """Return a rig in its initial state, for elements of any material."""
    memory, p, d = elements
    state = np.zeros(1, RIG_STATE)
    state["d"] = state["trial_d"] = d
    workspace = np.empty_like(p), np.empty_like(p)
    return Rig(form, control, line, memory.copy(), p.copy(), *workspace, state)


@attempt.register(Rig)
def _attempt(rig, places, dt):
    law, n, state = law_of(rig.form, dt), rig.p.size, rig.state[0]
    z = np.empty(n)
    heights_at(rig.line, *interval_at(rig.line, places.after), z)
    predict(law, rig.memory, rig.p, rig.w)
    c = z - rig.w
    state["trial_d"] = balance(rig.control, law, z, c, None, state["d"], 0)[0]
    for i in range(n):
        depth = state["trial_d"] - c[i]
        rig.new[i] = law.stiffness * depth if depth > 0.0 else 0.0
    touching = np.flatnonzero(rig.new)
    return trial_friction(rig, places, law.lag, touching, rig.new[touching]), law.lag


@kernel
def trial_friction(rig, places, lag, touching, p):
    """Return the friction of a step between two places (eq. 5); store the other sums in the rig.

    touching : indices of the touching elements. p : their forces. lag : see ``attempt``.
    """
    line, n = rig.line, rig.line.polynomials.shape[1] // 2
    (before, s), (after, t) = interval_at(line, places.before), interval_at(line, places.after)
    slope = np.empty(touching.size)
    for j in range(touching.size):
        slope[j] = slope_at(line, after + touching[j], t)
        if lag > 0.0:
            slope[j] += lag * (slope_at(line, before + touching[j], s) - slope[j])
    normal, friction, count = weighted_sums(-p, None, slope, 0.0)
    state = rig.state[0]
    state["normal_sum"], state["touching_sum"] = normal, count
    return friction / n


@accept.register(Rig)
def _accept(rig, dt):
    law, state = law_of(rig.form, dt), rig.state[0]
    advance_memory(law, rig.memory, rig.w, rig.p, rig.new)
    rig.p[:] = rig.new
    d = state["trial_d"] + law.lag * (state["d"] - state["trial_d"])
    state["d"] = state["trial_d"]
    return state["normal_sum"] / rig.p.size, d, state["touching_sum"] / rig.p.size


@patch_width.register(Rig)
def _patch_width(rig):
    return samples_per_contact(rig.p)
