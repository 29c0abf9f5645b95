"""What of cases no line changes: they are checked and sorted once, for all lines of a batch."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..model.limits import LOAD_LIMITS, SPEED_LIMITS, check_range
from ..rheology.spectrum import min_step
from .case import Case, Quantities
from .contacts.steady_friction import AtSpeed

LEAST_STEP = 1e-9  # |r - 1|, or zero; r is then known to 1e-7 of it, the jump to 1e-5


class Together(NamedTuple):
    """Cases of Kelvin elements that differ in their loads, and in what is kept."""

    rows: list[int]  # which of all cases they are
    cases: list[Case]
    loads: np.ndarray  # Fbar, shape (cases,)
    at_speed: AtSpeed  # at v1
    following: tuple[AtSpeed, ...]  # at each v2 that is asked for
    nothing: np.ndarray  # shape (ratios,): NaN, not to be changed


class Prepared(NamedTuple):
    """Cases for lines of so many steps per spacing."""

    steps_per_spacing: int
    asked: Quantities
    cases: tuple[Case, ...]
    together: tuple[Together, ...]
    alone: tuple[int, ...]  # which cases have elements with internal variables


def prepare(cases: Sequence[Case], steps_per_spacing: int, asked: Quantities) -> Prepared:
    """Check cases and sort them: those of Kelvin elements that can be found together.

    Raises ValueError for a case without meaning, or beyond what doubles can resolve.
    """
    alone: list[int] = []
    alike: dict[tuple, list[int]] = {}
    for i, case in enumerate(cases):
        _check(case, steps_per_spacing, asked)
        if case.plain:
            key = case.speed, case.scheme, case.ratios, case.refine
            alike.setdefault(key, []).append(i)
        else:
            alone.append(i)
    together = (_together(rows, cases, steps_per_spacing, asked) for rows in alike.values())
    return Prepared(steps_per_spacing, asked, tuple(cases), tuple(together), tuple(alone))


def _together(rows: list[int], cases: Sequence[Case], steps: int, asked: Quantities) -> Together:
    own = [cases[i] for i in rows]
    speed, ratios, scheme = own[0].speed, own[0].ratios, own[0].scheme
    after = tuple(ratio * speed for ratio in ratios)
    to = after if asked.jump or asked.relaxation else ()
    following = after if asked.steady or asked.relaxation else ()
    at_speed = AtSpeed.of(scheme, steps, speed, to)
    twos = tuple(AtSpeed.of(scheme, steps, later) for later in following)
    loads, nothing = np.array([case.load for case in own]), np.full(len(ratios), np.nan)
    return Together(rows, own, loads, at_speed, twos, nothing)


def _check(case: Case, steps: int, asked: Quantities) -> None:
    speeds = [abs(speed) for speed in (case.speed, *(r * case.speed for r in case.ratios))]
    check_range("load", case.load, LOAD_LIMITS)
    for speed in speeds:
        check_range("speed", speed, SPEED_LIMITS)
    for ratio in case.ratios:
        if 0.0 < abs(ratio - 1.0) < 0.99 * LEAST_STEP:  # or 1e-9 itself would round out of it
            raise ValueError(f"ratio = 1 + {ratio - 1.0:g}: the step is lost in rounding")
    shortest = 1.0 / (steps * max(speeds))
    if shortest < min_step(case.spectrum):
        raise ValueError(f"speed = {max(speeds):g}: steps of {shortest:g} tau are lost in rounding")
    for kept in case.kept_steps if asked.relaxation else ():
        if not (len(kept) and kept[0] >= 1 and (kept[1:] > kept[:-1]).all()):
            raise ValueError("kept_steps must hold increasing step numbers from 1 on")
