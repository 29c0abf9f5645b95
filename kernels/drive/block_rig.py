"""A rig of Prony series, of whose elements those alone are stepped that can touch.

Which they are, and how memory counts, is as in scene/march_blocks.py. What a step does to the
memory is known once it is taken: its first try takes the memory over the step before it.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import Elements, law_of
from ..rheology.retardation import Retardation
from ..rheology.scaled import BLOCK, go_on, look_ahead
from ..scene.march_blocks import (
    SLACK,
    ElementBlocks,
    Rows,
    balance_blocks,
    cap_over,
    choose_blocks,
    in_blocks,
    press_blocks,
    room_for_blocks,
    round_apart,
)
from ..scene.samples import samples_per_contact
from .posed_line import PosedLine, heights_at, seen_from
from .rig import accept, attempt, friction_of, patch_width

TAKEN, LAST, BEGIN, COUNT = range(4)  # of the numbers of a rig
D, TRIED, CHOSEN, CAP = range(4)  # of its indentations


class BlockRig(NamedTuple):
    """A line on its elements; its arrays are changed in place."""

    form: Retardation
    control: Any  # what the indentation follows from (model/balance.py)
    line: PosedLine
    blocks: ElementBlocks
    p: np.ndarray  # shape (2, blocks, BLOCK): forces of the last step and of that before, in turns
    rows: Rows
    z: np.ndarray  # shape (n,): heights at the blocks that can touch
    number: np.ndarray  # shape (4,): steps taken; in which turn the last one is; interval of
    # element 0 where blocks were chosen, or -1; and how many they are
    d: np.ndarray  # shape (4,): indentation after the last step, in that which is tried, and where
    # blocks were chosen; and the cap below which they are known
    sums: np.ndarray  # shape (2,): of forces in the step that is tried, of elements that touch


def block_rig(form: Any, control: Any, line: PosedLine, elements: Elements) -> BlockRig:
    """Return a rig of elements that have taken no step; form : a Retardation."""
    state, n = in_blocks(elements, 0), elements.p.size
    p, rows = np.stack([state.p, state.older]), room_for_blocks(state.blocks.seen.size)
    number, d = np.array([0, 0, -1, 0]), np.array([state.d, state.d, state.d, np.inf])
    room = rows, np.empty(n), number, d, np.empty(2)
    return BlockRig(form, control, line, state.blocks, p, *room)


@attempt.of(BlockRig)
def _attempt(rig, places, dt):
    law, n, old = law_of(rig.form, dt), rig.z.size, rig.d[D]
    look_ahead(law, rig.blocks.scales)
    begin, t = seen_from(rig.line, places.after)
    if rig.number[BEGIN] < 0 or round_apart(begin, rig.number[BEGIN], n) > SLACK:
        _choose(rig, begin, old, rig.d[CHOSEN])
        rig.number[BEGIN], rig.d[CHOSEN] = begin, old
    _balance(rig, law, begin, t)
    while rig.rows.springs.highest[0] > rig.d[CAP]:  # what was left out would have been looked at
        _choose(rig, rig.number[BEGIN], rig.rows.springs.highest[0], old)
        _balance(rig, law, begin, t)
    c, d, count = rig.rows.springs.c, rig.d[TRIED], 0
    some, p = np.empty(n, np.int64), np.empty(n)
    for row in range(rig.number[COUNT]):
        first = rig.rows.active[row] * BLOCK
        for i in range(BLOCK):
            if c[row, i] < d:
                some[count], p[count] = first + i, law.stiffness * (d - c[row, i])
                count += 1
    return friction_of(rig, places, law.lag, some[:count], p[:count]), law.lag


@kernel
def _choose(rig, begin, d, before):
    """Choose the blocks that can touch where the indentation is d, and was another before."""
    rig.d[CAP] = cap_over(d, before, rig.line.lowest)
    chosen = rig.rows.active, rig.line.lowest, begin, rig.z.size, rig.d[CAP], rig.blocks.pressed
    rig.number[COUNT] = choose_blocks(*chosen)


@kernel
def _balance(rig, law, begin, t):
    """Find the indentation of a step at whose end element 0 is at t of an interval."""
    count, last = rig.number[COUNT], rig.number[LAST]
    for b in rig.rows.active[:count]:
        heights_at(rig.line, begin + b * BLOCK, t, rig.z[b * BLOCK : (b + 1) * BLOCK])
    p, step = (rig.p[last], rig.p[1 - last]), rig.number[TAKEN] + 1
    found = balance_blocks(rig.control, law, rig.blocks, *p, step, count, rig.rows, rig.z, rig.d[D])
    rig.d[TRIED] = found[0]


@accept.of(BlockRig)
def _accept(rig, dt):
    law = law_of(rig.form, dt)
    rig.number[TAKEN] += 1
    rig.number[LAST] = 1 - rig.number[LAST]
    some, new = rig.rows.active[: rig.number[COUNT]], rig.p[rig.number[LAST]]
    press_blocks(law, rig.blocks.pressed, new, some, rig.rows.springs.c, rig.d[TRIED])
    go_on(law, rig.blocks.scales, rig.number[TAKEN])
    d = rig.d[TRIED] + law.lag * (rig.d[D] - rig.d[TRIED])
    rig.d[D] = rig.d[TRIED]
    return rig.sums[0] / rig.z.size, d, rig.sums[1] / rig.z.size


@patch_width.of(BlockRig)
def _patch_width(rig):
    return samples_per_contact(rig.p[rig.number[LAST]].reshape(-1)[: rig.z.size])
