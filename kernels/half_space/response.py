"""Response of the steps of a march to a steadily travelling wave of pressures.

In the frame of the surface an element comes to a sample from the sample before. A wave exp(i q x)
of the memory is therefore multiplied by zeta = exp(i q_x delta) in a step, delta being a sample, if
the surface moves towards +x, and by the conjugate if it moves towards -x. A law (rheology/law.py)
is linear: under a unit force its memory is y and its displacement -J,

    y = T zeta y + a zeta + b,    -J = zeta (c y + e) - 1/K.

T, a, b, c and e are obtained from the law by unit memory_size and forces.
"""

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import predict
from .body import settle_memory


@kernel
def predicted(law, memory, p):
    """Return the displacements without a force in the step, shape (n,)."""
    w = np.empty(p.size)
    predict(law, memory, p, w)
    return w


def steady_response(law, count: int, zeta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (J, memory) of steady waves of force one.

    law : of steps of one sample. count : M, number of internal variables. zeta : as above, of any
    shape. J : complex compliance over that of the relaxed body, of the same shape.
    memory : shape (M, *shape of zeta).
    """
    # Columns: one unit of each memory, of the old force, of the new force.
    memory, old, new = np.eye(count, count + 2), np.zeros(count + 2), np.zeros(count + 2)
    old[count] = new[count + 1] = 1.0
    w = predicted(law, memory, old)
    settle_memory(law, memory, w.copy(), old, new)
    phase = zeta.ravel()[:, None]
    source = phase * memory[:, count] + memory[:, count + 1]
    matrix = np.eye(count) - phase[:, :, None] * memory[:, :count]
    y = np.linalg.solve(matrix, source[:, :, None])[:, :, 0]
    compliance = 1.0 / law.stiffness - phase[:, 0] * (y @ w[:count] + w[count])
    return compliance.reshape(zeta.shape), y.T.reshape(count, *zeta.shape)
