"""A rig of Prony series, of whose elements those alone are stepped that can touch.

Which they are, and how memory counts, is as in scene/march_blocks.py. What a step does to the
memory is known once it is taken.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..model.balance import balance_rows
from ..rheology.law import Elements, law_of
from ..rheology.retardation import Retardation
from ..rheology.scaled_units import BLOCK_ELEMENTS, advance_scales, predict_block, rescale_blocks
from ..scene.march_blocks import SLACK, ElementBlocks, can_touch, cap_over, in_blocks, round_apart
from ..scene.samples import samples_per_contact
from ..scene.spring_rows import SpringRows, refilled, spring_rows_of
from .posed_line import PosedLine, heights_at, seen_from
from .rig import accept, attempt, friction_of, patch_width

TAKEN, BEGIN, COUNT = range(3)  # of the numbers of a rig
D, TRIED, CHOSEN, CAP = range(4)  # of its indentations


class BlockRig(NamedTuple):
    """A line on its elements; its arrays are changed in place."""

    form: Retardation
    control: Any  # what the indentation follows from (model/balance.py)
    line: PosedLine
    blocks: ElementBlocks  # whose memory knows of all forces
    p: np.ndarray  # shape (blocks, BLOCK_ELEMENTS): forces of the last step
    rows: SpringRows
    z: np.ndarray  # shape (n,): heights at the blocks that can touch
    number: np.ndarray  # shape (3,): steps taken; interval of element 0 where blocks were chosen,
    # or -1; and how many they are
    d: np.ndarray  # shape (4,): indentation after the last step, in that which is tried, and where
    # blocks were chosen; and the cap below which they are known
    sums: np.ndarray  # shape (2,): of forces in the step that is tried, of elements that touch


def block_rig(form: Any, control: Any, line: PosedLine, elements: Elements) -> BlockRig:
    """Return a rig of elements that have taken no step; form : a Retardation."""
    state, n = in_blocks(elements, 0), elements.p.size
    p, rows = np.maximum(-state.c, 0.0), spring_rows_of(state.c)
    number, d = np.array([0, -1, 0]), np.array([state.d, state.d, state.d, np.inf])
    room = rows, np.empty(n), number, d, np.empty(2)
    return BlockRig(form, control, line, state.blocks, p, *room)


@attempt.register(BlockRig)
def _attempt(rig, places, dt):
    law, n, old = law_of(rig.form, dt), rig.z.size, rig.d[D]
    begin, t = seen_from(rig.line, places.after)
    if rig.number[BEGIN] < 0 or round_apart(begin, rig.number[BEGIN], n) > SLACK:
        _choose(rig, begin, old, rig.d[CHOSEN])
        rig.number[BEGIN], rig.d[CHOSEN] = begin, old
    _balance(rig, law, begin, t)
    while rig.rows.highest[0] > rig.d[CAP]:  # what was left out would have been looked at
        _choose(rig, rig.number[BEGIN], rig.rows.highest[0], old)
        _balance(rig, law, begin, t)
    c, d, count = rig.rows.c, rig.d[TRIED], 0
    some, p = np.empty(n, np.int64), np.empty(n)
    for b in rig.rows.some[: rig.number[COUNT]]:
        for i in range(BLOCK_ELEMENTS):
            if c[b, i] < d:
                some[count], p[count] = b * BLOCK_ELEMENTS + i, law.stiffness * (d - c[b, i])
                count += 1
    return friction_of(rig, places, law.lag, some[:count], p[:count]), law.lag


@kernel
def _choose(rig, begin, d, before):
    """Choose the blocks that can touch where the indentation is d, and was another before."""
    cap, count = cap_over(d, before, rig.line.lowest), 0
    for b in range(rig.p.shape[0]):
        if can_touch(rig.line.lowest, begin, b, rig.z.size, cap) or np.any(rig.p[b] > 0.0):
            rig.rows.some[count] = b
            count += 1
    rig.d[CAP], rig.number[COUNT] = cap, count


@kernel
def _balance(rig, law, begin, t):
    """Find the indentation of a step at whose end element 0 is at t of an interval."""
    memory, seen, scales = rig.blocks
    c, _, sums, highest, found = rig.rows
    some, old, now = rig.rows.some[: rig.number[COUNT]], rig.d[D], law.stale.sum()
    rows = SpringRows(c, some, sums, highest, found)
    rescale_blocks(scales, memory, seen, some, rig.number[TAKEN])
    share, w = law.decay * scales.scale, np.empty(BLOCK_ELEMENTS)
    refilled(rows)
    for b in some:
        z = rig.z[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        heights_at(rig.line, begin + b * BLOCK_ELEMENTS, t, z)
        predict_block(share, memory, b, w)
        for i in range(z.size):
            c[b, i] = z[i] - (w[i] - now * rig.p[b, i])
    rig.d[TRIED] = balance_rows(rig.control, law, rows, old, rig.number[TAKEN] + 1)[0]


@accept.register(BlockRig)
def _accept(rig, dt):
    law = law_of(rig.form, dt)
    memory, seen, scales = rig.blocks
    rig.number[TAKEN] += 1
    advance_scales(law, scales, rig.number[TAKEN])
    some = rig.rows.some[: rig.number[COUNT]]
    rescale_blocks(scales, memory, seen, some, rig.number[TAKEN])
    fresh, stale = law.fresh / scales.scale, law.stale / scales.scale
    for b in some:
        for i in range(BLOCK_ELEMENTS):
            depth = rig.d[TRIED] - rig.rows.c[b, i]
            new, old = law.stiffness * depth if depth > 0.0 else 0.0, rig.p[b, i]
            rig.p[b, i] = new
            for k in range(fresh.size if new > 0.0 or old > 0.0 else 0):
                memory[b, k, i] -= fresh[k] * new + stale[k] * old
    d = rig.d[TRIED] + law.lag * (rig.d[D] - rig.d[TRIED])
    rig.d[D] = rig.d[TRIED]
    return rig.sums[0] / rig.z.size, d, rig.sums[1] / rig.z.size


@patch_width.register(BlockRig)
def _patch_width(rig):
    return samples_per_contact(rig.p.reshape(-1)[: rig.z.size])
