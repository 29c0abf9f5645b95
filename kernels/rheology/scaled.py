"""Units counted in what decays as they do: an element that nothing presses needs no step.

With y_k = S_k a_k, and S_k <- E_k S_k in every step, a step of prony.py reads

    a_k <- a_k - (B_k / S_k) p_new - (A_k / S_k) p_old,

which leaves the a_k of a free element alone, to the bit. Before S_k underflows it is divided by
SHRUNK, and every a_k is multiplied by it: a power of two, so that an element may learn of it at
any time and has the same bits. What has met that twice is gone, and so is all memory of a unit
that decays below FORGOTTEN in one step.

Elements come in blocks of BLOCK, so that what a loop runs through is in the first cache.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined, kernel

BLOCK = 64
SHRUNK = 2.0**-512
GONE = 2.0**-480  # scaled memory below it is zero
FORGOTTEN = 2.0**-100  # far below the last digit of what the step adds


class Scales(NamedTuple):
    """What is common to the units of all elements, each of shape (K,)."""

    scale: np.ndarray  # S_k
    last: np.ndarray  # the last step at which memory was to be multiplied by SHRUNK, or wiped
    before: np.ndarray  # the one before; the same as last where memory was wiped
    fresh: np.ndarray  # B_k / S_k of the step that memory is to be taken over next; or 0: none
    stale: np.ndarray  # A_k / S_k
    ahead: np.ndarray  # E_k S_k of the step that comes


@kernel
def as_it_is(units, step):
    """Return the Scales of a number of units whose memory counts as it is, after a step."""
    zeros, steps = np.zeros((3, units)), np.full((2, units), step)
    return Scales(np.ones(units), steps[0], steps[1], zeros[0], zeros[1], zeros[2])


@inlined
def look_ahead(law, scales):
    """Prepare for the step that comes; law : a Prony."""
    for k in range(law.decay.size):
        scales.ahead[k] = law.decay[k] * scales.scale[k]


@inlined
def go_on(law, scales, step):
    """Take the scales over a step; it is the next that memory is to be taken over."""
    for k in range(law.decay.size):
        scale = scales.ahead[k]
        if law.decay[k] < FORGOTTEN:
            scale = 1.0
            scales.before[k] = scales.last[k] = step
        elif scale < SHRUNK:
            scale /= SHRUNK
            scales.before[k], scales.last[k] = scales.last[k], step
        scales.scale[k] = scale
        scales.fresh[k] = law.fresh[k] / scale
        scales.stale[k] = law.stale[k] / scale


@inlined
def catch_up(scales, memory, seen, some, step):
    """Shrink the memory of some blocks by what they have not seen until a step.

    memory : shape (blocks, K, BLOCK). seen : the last step that each has seen.
    """
    for b in some:
        for k in range(scales.last.size if seen[b] < step else 0):
            if scales.last[k] > seen[b]:
                factor = SHRUNK if scales.before[k] <= seen[b] else 0.0
                for i in range(BLOCK):
                    y = factor * memory[b, k, i]
                    memory[b, k, i] = y if abs(y) > GONE else 0.0
        seen[b] = max(seen[b], step)


@inlined
def settle_and_predict(law, scales, memory, pressed, p, older, some, z, total, c):
    """Fill rows of c with z - w, w being where elements of some blocks would come without force.

    The memory of those that are pressed is taken over the last step in the same pass.
    law : a Prony, of the step that comes. pressed : whether, of all blocks. p, older : forces of
    the last step and of the one before, shape (blocks, BLOCK). z : shape (n,). total : room for
    3 BLOCK numbers. c : a row for each of some blocks, infinite beyond n.
    """
    now = 0.0
    for k in range(law.stale.size):
        now += law.stale[k]
    for row in range(some.size):
        b = some[row]
        if pressed[b] > 0:
            for i in range(BLOCK):  # arrays that could overlap are looked at for it in every loop
                total[i] = -now * p[b, i]
                total[BLOCK + i] = p[b, i]
                total[2 * BLOCK + i] = older[b, i]
            _settle_and_predict(scales.ahead, scales.fresh, scales.stale, memory, b, total)
        else:
            for i in range(BLOCK):
                total[i] = 0.0
            _predict(scales.ahead, memory, b, total)
        here = z[b * BLOCK : (b + 1) * BLOCK]
        for i in range(here.size):
            c[row, i] = here[i] - total[i]
        for i in range(here.size, BLOCK):
            c[row, i] = np.inf


@inlined
def _predict(ahead, memory, b, total):
    """Add to ``total`` what the units of block b displace it."""
    for k in range(ahead.size):
        share = ahead[k]
        for i in range(BLOCK):
            total[i] += share * memory[b, k, i]


@inlined
def _settle_and_predict(ahead, fresh, stale, memory, b, total):
    """Do the same after the last step, whose forces are in the last two thirds of ``total``."""
    for k in range(ahead.size):
        share, new, old = ahead[k], fresh[k], stale[k]
        for i in range(BLOCK):
            y = memory[b, k, i] - new * total[BLOCK + i] - old * total[2 * BLOCK + i]
            memory[b, k, i] = y
            total[i] += share * y


@inlined
def all_settled(scales):
    """Note that the memory of all that is pressed knows of the last step."""
    for k in range(scales.fresh.size):
        scales.fresh[k] = scales.stale[k] = 0.0
