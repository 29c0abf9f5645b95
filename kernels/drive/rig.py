"""What is pulled: elements under a surface, and a step of them that is tried before it is taken.

A rig is that of a line here, and of a map in half_space/pulled_map.py; the functions declared here
are reached by its type.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import by_type, kernel
from ..model.balance import balance
from ..model.friction import weighed
from ..rheology.law import law_of, predict, settle


@by_type
def attempt(rig, pose, dt):
    """Return (friction, lag) of a step that ends in a pose; the rig keeps what is found.

    friction : F_x in the units of the drive (spring.py). lag : where within the step it acts,
    before its end, as a share of it.
    """


@by_type
def accept(rig, dt):
    """Take the step that was tried last; return (normal force, indentation, share in contact).

    The indentation is that at which the force acts, in h; the normal force is in 4 G L h, or in
    E* L h of a half-space.
    """


class Rig(NamedTuple):
    """A line on its elements; its arrays are changed in place."""

    form: Any  # of the material (rheology/forms.py)
    control: Any  # what the indentation follows from (model/balance.py)
    memory: np.ndarray  # shape (M, n): of the elements
    p: np.ndarray  # shape (n,): forces of the last step, in 4 G dx h
    w: np.ndarray  # shape (n,): where elements would go in the step that is tried
    new: np.ndarray  # shape (n,): forces in it
    some: np.ndarray  # shape (n,): elements that can touch in it come first
    d: np.ndarray  # shape (4,): indentation after the last step, in that which is tried, a cap of
    # the latter, and by how much it is higher than the former at least


class Pose(NamedTuple):
    """A line as the elements see it at the end of a step, and its slopes before the step."""

    z: np.ndarray  # shape (n,), in h
    before: np.ndarray  # slopes, shape (n,), in h/dx
    after: np.ndarray  # slopes at the end


@attempt.of(Rig)
def _attempt(rig, pose, dt):
    return _tried(rig, pose, dt)


@accept.of(Rig)
def _accept(rig, dt):
    return _taken(rig, dt)


@kernel
def _tried(rig, pose, dt):
    """Return what attempt does, of a line.

    Where the line lies above a cap that the indentation does not reach none touches: elements are
    never pulled up.
    """
    law = law_of(rig.form, dt)
    c = np.empty(rig.p.size)
    rig.d[1], count = _balanced(rig, law, pose, rig.d[2], c)
    if rig.d[1] > rig.d[2]:
        rig.d[1], count = _balanced(rig, law, pose, np.inf, c)
    slope = np.empty(count)
    rig.new[:] = 0.0
    for j in range(count):
        i = rig.some[j]
        depth = rig.d[1] - c[j]
        rig.new[i] = law.stiffness * depth if depth > 0.0 else 0.0
        slope[j] = pose.after[i] + law.lag * (pose.before[i] - pose.after[i])
        c[j] = -rig.new[i]
    return weighed(c[:count], None, slope, 0.0)[1] / rig.p.size, law.lag


@kernel
def _balanced(rig, law, pose, cap, c):
    """Return (d, count) of a step in which the elements alone can touch that are below a cap.

    c : room for n thresholds. The first of ``some`` are those elements, and w is known there.
    """
    n, count, i = rig.p.size, 0, 0
    while i < n:
        if not pose.z[i] < cap:
            i += 1
            continue
        begin = i
        while i < n and pose.z[i] < cap:
            rig.some[count] = i
            count += 1
            i += 1
        predict(law, rig.memory[:, begin:i], rig.p[begin:i], rig.w[begin:i])
    if count == 0:
        return np.inf, 0
    z = np.empty(count)
    for j in range(count):
        z[j] = pose.z[rig.some[j]]
        c[j] = z[j] - rig.w[rig.some[j]]
    return balance(rig.control, law, z, c[:count], None, rig.d[0], 0)[0], count


@kernel
def _taken(rig, dt):
    """Return what accept does, of a line."""
    law = law_of(rig.form, dt)
    settle(law, rig.memory, rig.w, rig.p, rig.new)
    normal, touching = 0.0, 0
    for i in range(rig.p.size):
        rig.p[i] = rig.new[i]
        normal += rig.new[i]
        touching += rig.new[i] > 0.0
    d = rig.d[1] + law.lag * (rig.d[0] - rig.d[1])
    rig.d[2] = rig.d[1] + max(rig.d[3], 4.0 * abs(rig.d[1] - rig.d[0]))
    rig.d[0] = rig.d[1]
    return normal / rig.p.size, d, touching / rig.p.size
