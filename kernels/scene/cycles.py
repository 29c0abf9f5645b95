"""Friction averaged over cycles of an oscillation, from every step of them.

The mean is that of the friction force over that of the normal force: under a constant normal force
the mean of mu over time. It is taken over the later half of the cycles, as the first ones still
know of the start.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..motion.legs import Oscillation, Programme, Steps
from .scene_case import SceneCase


class Spell(NamedTuple):
    """Impulses of normal force and friction over some steps, whether they are kept or not."""

    after: int  # the number of the step before the first of them
    last: int
    sums: np.ndarray  # of both, shape (2,): friction over normal force is in h/dx


def later_cycles(programme: Programme, steps: Steps) -> tuple[int, int]:
    """Return the steps at which the later half of the cycles of the last oscillation begins, ends.

    Of an odd number of cycles the one in the middle belongs to them. Steps are counted from 1 on.
    Raises ValueError where nothing oscillates.
    """
    swung = [number for number, leg in enumerate(programme) if isinstance(leg, Oscillation)]
    if not swung:
        raise ValueError('asked = "cycle_mean": no leg of the programme oscillates')
    leg = programme[swung[-1]]
    assert isinstance(leg, Oscillation)
    last = int(np.searchsorted(steps.leg, swung[-1], side="right"))
    ends = np.append(0.0, np.cumsum(steps.dt))[: last + 1]
    begin = ends[-1] - (leg.cycles + 1) // 2 / leg.frequency
    return int(np.argmin(np.abs(ends - begin))), last


def spell_of(scene: SceneCase, steps: Steps) -> Spell | None:
    """Return the spell over which friction is averaged; None where that is not asked for."""
    if "cycle_mean" not in scene.asked:
        return None
    return Spell(*later_cycles(scene.programme, steps), np.zeros(2))


def mean_of(spell: Spell | None) -> dict[str, np.ndarray]:
    """Return the mean friction over the mean normal force in a spell, by name, in h/dx."""
    if spell is None:
        return {}
    normal, friction = spell.sums
    return {"mu_cycle_mean": np.array(friction / normal if normal > 0.0 else np.nan)}


@kernel
def add_impulses(spell, sums, dt):
    """Add a step to a spell; sums : of eq. 5 (model/friction.py)."""
    spell.sums[0] += dt * sums[0]
    spell.sums[1] += dt * sums[1]
