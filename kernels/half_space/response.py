"""What a step of the march makes of a wave of pressures that is carried along steadily.

In the frame of the surface an element comes to a sample from the one before, so that a wave
exp(i q x) of what elements remember is turned by zeta = exp(i q_x delta), delta a sample, while
the surface moves towards +x, and back while it moves towards -x. All that a law does
(rheology/law.py) is linear: with a unit force it remembers y and is displaced by -J,

    y = T zeta y + a zeta + b,    -J = zeta (c y + e) - 1/K.

T, a, b, c, e are read off the law itself, by unit memories and forces.
"""

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import predict
from .body import take


@kernel
def predicted(law, memory, p):
    """Return the displacements without force in the step, shape (n,)."""
    w = np.empty(p.size)
    predict(law, memory, p, w)
    return w


def steady_response(law, count: int, zeta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (J, memory) of steady waves of force one.

    law : of steps of one sample. count : M, its internal variables. zeta : as above, any shape.
    J : complex compliance, the shape of zeta, of the relaxed body's; memory : (M, *that shape).
    """
    # Columns: a unit of every memory, of the old force, of the new force.
    memory, old, new = np.eye(count, count + 2), np.zeros(count + 2), np.zeros(count + 2)
    old[count] = new[count + 1] = 1.0
    w = predicted(law, memory, old)
    take(law, memory, w.copy(), old, new)
    turn = zeta.ravel()[:, None]
    drive = turn * memory[:, count] + memory[:, count + 1]
    back = np.eye(count) - turn[:, :, None] * memory[:, :count]
    y = np.linalg.solve(back, drive[:, :, None])[:, :, 0]
    compliance = 1.0 / law.stiffness - turn[:, 0] * (y @ w[:count] + w[count])
    return compliance.reshape(zeta.shape), y.T.reshape(count, *zeta.shape)
