"""March of a line over the elements, with the indentation given by a control.

The package ``motion`` moves the elements along the line, ``rheology`` gives their response in a
step, and ``control`` gives the indentation. Laws and controls are dispatched on their types: numba
compiles a version for each pair, without code of the others.
"""

import numpy as np

from ..compile.jit import kernel
from ..motion.slide import gather, piece_bounds, shift, start_rings, touchable
from .balance import balance, balance_history
from .friction import step_average


@kernel
def march(law, control, z, weight, state, kept_steps, cap):
    """March from a state of the elements; return (mu, indentation, passes, inside).

    law : of the elastomer, for steps of one sample (rheology), e.g. Kelvin.
    control : of the indentation (control), e.g. ConstantForce.
    z, weight : line (in h) and lagged slope (in h/dx), shape (n,), z[0] the highest point.
    state : the elements before the first step (rheology/law.py), e.g. of steady sliding.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are kept.
    cap : samples above it are assumed never to touch. inside : whether d stayed at or below cap.
    mu : friction averaged over the step (friction.py), in h/dx, shape of kept_steps.
    indentation : d at the end of the step, in h. passes : over the thresholds, in all steps.
    """
    start, stop = touchable(z, cap)
    lengths = np.empty(start.size, np.int64)
    for s in range(start.size):
        lengths[s] = stop[s] - start[s]
    first = piece_bounds(lengths)
    rings = start_rings(law, z, state, start, stop)
    # Samples above cap in short gaps cannot touch; lowering them to cap keeps the digits of w.
    z, weight, w = gather(z, start, stop), gather(weight, start, stop), gather(state.w, start, stop)
    c, d = np.empty(z.size), state.d
    for i in range(z.size):
        z[i] = min(z[i], cap)
        c[i] = z[i] - w[i]

    mu = np.empty(kept_steps.size)
    indentation = np.empty(kept_steps.size)
    recorded = 0
    passes = 0
    for step in range(1, kept_steps[-1] + 1):
        history = balance_history(control, c, d, first, rings)
        shift(law, z, c, d, first, rings, step)
        d, used = balance(control, law, z, c, history, d, step)
        passes += used
        if d > cap:
            return mu, indentation, passes, False
        if step == kept_steps[recorded]:
            mu[recorded] = step_average(weight, c, d)
            indentation[recorded] = d
            recorded += 1
    return mu, indentation, passes, True
