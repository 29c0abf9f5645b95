"""Response of a step of a march to a steadily travelling wave of pressures.

In the frame of the surface, each element moves by one sample in a step. A step therefore multiplies
a wave exp(i q x) of the memory by zeta = exp(i q_x delta), where delta is the length of a sample,
if the surface moves towards +x, and by its conjugate if the surface moves towards -x. A law is
linear (rheology/law.py): under a wave of unit force, its memory y and displacement -J satisfy

    y = T zeta y + a zeta + b,    -J = zeta (c y + e) - 1/K.

T, a, b, c and e are obtained by applying the law to unit memory and unit forces.
"""

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import predict
from .body import settle_memory


@kernel
def predicted(law, memory, p):
    """Return the displacements at the end of a step without force, shape (n,)."""
    w = np.empty(p.size)
    predict(law, memory, p, w)
    return w


def steady_response(law, count: int, zeta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (J, memory) of steady waves of unit force.

    law : of a step of one sample. count : M, number of internal variables. zeta : as above, of any
    shape. J : complex compliance over that of the relaxed body, of the shape of zeta.
    memory : shape (M, *shape of zeta).
    """
    # Columns: a unit of each internal variable, of the old force, and of the new force.
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
