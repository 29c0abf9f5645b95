"""Relaxation after the velocity jump: marching the line by whole samples.

With an element at every sample, a step moves each element to the next sample of the line;
nothing is interpolated. State and thresholds are kept at the samples of the line, and only
where it can touch: stretches of z < cap. Elements in the gaps between them just decay; a ring
per gap hands them from one stretch to the next.
"""

import numpy as np

from kernels.contact import solve_indentation
from kernels.friction import step_average
from kernels.jit import kernel
from kernels.rheology.kelvin import NEGLIGIBLE

SHORT_GAP = 16  # gaps up to this many samples are cheaper to carry along than to skip


@kernel
def touchable(z, cap):
    """Return (start, stop) of the stretches of z < cap, in line order, both int64 arrays.

    z[0] must not be below cap unless all of z is.
    """
    start = np.empty(z.size // 2 + 1, np.int64)
    stop = np.empty(z.size // 2 + 1, np.int64)
    count = 0
    for j in range(z.size):
        if z[j] < cap:
            if count > 0 and j - stop[count - 1] <= SHORT_GAP:
                stop[count - 1] = j + 1
            else:
                start[count] = j
                stop[count] = j + 1
                count += 1
    return start[:count].copy(), stop[:count].copy()


@kernel
def march(z, weight, w, d, decay, stiffness, load, kept_steps, cap, rigid=None):
    """March from the steady state (w, d) and return (mu, indentation, passes, inside).

    z, weight, w : line, lagged slope and free displacements, shape (n,), z[0] the highest point.
    decay, stiffness : of the step at the new speed. load : n Fbar.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are kept.
    cap : elements above it are taken never to touch; inside tells whether d stayed below.
    rigid : None, or True to drop the indentation rate from the force, as eq. 3 is printed. numba
    compiles a version for each type of it, so that what is not asked for is not in the code.
    mu : friction averaged over the step (friction.py), in h/dx, shape of kept_steps.
    """
    start, stop = touchable(z, cap)
    stretches = start.size
    first = np.zeros(start.size + 1, np.int64)
    first[1:] = np.cumsum(stop - start)
    ring, ring_at, crossing = _rings(z, w, d, decay, start, stop)
    # What lies above cap in short gaps cannot touch at any height: low, it costs w no digits.
    z, weight = np.minimum(_gather(z, start, stop), cap), _gather(weight, start, stop)
    c = z - _gather(w, start, stop)

    mu = np.empty(kept_steps.size)
    indentation = np.empty(kept_steps.size)
    kept = 0
    passes = 0
    held = np.zeros(c.size if rigid is not None else 0, np.bool_)
    for step in range(1, kept_steps[-1] + 1):
        if rigid is not None:
            _mark_held(c, d, first, held)
        _shift(z, c, d, decay, first, ring, ring_at, step)
        if rigid is None:
            d, used = solve_indentation(c, load / stiffness, d)
        else:
            d, used = _solve_rigid(z, c, held, decay, stiffness, load, d)
        passes += used
        if d > cap:
            return mu, indentation, passes, False
        for s in range(stretches):
            below = s - 1 if s > 0 else stretches - 1
            slot = ring_at[below] + step % (ring_at[below + 1] - ring_at[below])
            ring[slot] = crossing[below] * (z[first[s]] - max(c[first[s]], d))
        if step == kept_steps[kept]:
            mu[kept] = step_average(weight, c, d)
            indentation[kept] = d
            kept += 1
    return mu, indentation, passes, True


@kernel
def _rings(z, w, d, decay, start, stop):
    """Return (ring, ring_at, crossing): the displacements with which elements cross the gaps.

    Ring s covers the gap above stretch s. The element to arrive in t steps is in slot
    t % (gap + 1), decayed to its arrival; those in flight now decay anew from where they are.
    crossing : decay over a whole gap.
    """
    n = z.size
    gap = np.append(start[1:], start[0] + n) - stop
    ring_at = np.zeros(start.size + 1, np.int64)
    ring_at[1:] = np.cumsum(gap + 1)
    ring = np.empty(ring_at[-1])
    crossing = np.ones(start.size)
    for s in range(start.size):
        for t in range(1, gap[s] + 2):
            crossing[s] *= decay
            if crossing[s] < NEGLIGIBLE:
                crossing[s] = 0.0
            j = (stop[s] - 1 + t) % n
            ring[ring_at[s] + t % (gap[s] + 1)] = crossing[s] * min(w[j], z[j] - d)
    return ring, ring_at, crossing


@kernel
def _gather(values, start, stop):
    """Return the values of all stretches [start, stop) one after the other."""
    out = np.empty(np.sum(stop - start))
    a = 0
    for s in range(start.size):
        b = a + stop[s] - start[s]
        out[a:b] = values[start[s] : stop[s]]
        a = b
    return out


@kernel
def _shift(z, c, d, decay, first, ring, ring_at, step):
    """Move every element to the next sample: thresholds c of the step before contact."""
    for s in range(first.size - 1):
        for i in range(first[s], first[s + 1] - 1):
            c[i] = z[i] - decay * (z[i + 1] - max(c[i + 1], d))
        last = first[s + 1] - 1
        slot = ring_at[s] + step % (ring_at[s + 1] - ring_at[s])
        c[last] = z[last] - ring[slot]


@kernel
def _mark_held(c, d, first, held):
    """Mark the elements that arrive at each sample straight from contact one sample upstream."""
    for s in range(first.size - 1):
        for i in range(first[s], first[s + 1] - 1):
            held[i] = c[i + 1] < d
        held[first[s + 1] - 1] = False


@kernel
def _solve_rigid(z, c, held, decay, stiffness, load, d):
    """Balance the load where held elements move with the line but not with the indentation.

    Their last displacement counts as z - d with the new d: the rate of d costs no force. The
    force of a held element is then d - (z_i - decay z_(i+1))/(1 - decay). c is left consistent
    with the new d. Returns (d, passes).
    """
    threshold = c.copy()
    weight = np.full(c.size, stiffness)
    for i in range(c.size):
        if held[i]:
            threshold[i] = (z[i] - decay * z[i + 1]) / (1.0 - decay)
            weight[i] = 1.0
    d, passes = solve_indentation(threshold, load, d, weight)
    for i in range(c.size):
        if held[i]:
            c[i] = z[i] - decay * (z[i + 1] - d)
    return d, passes
