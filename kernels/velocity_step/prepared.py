"""Cases, checked and grouped once for all lines of a batch."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..model.limits import LOAD_LIMITS, SPEED_LIMITS, check_range
from ..quick.contacts.steady_friction import SpeedConstants
from ..rheology.spectrum import min_step
from .case import Case, Quantities

MIN_RATIO_STEP = 1e-9  # least |r - 1| > 0; rounding of r is 1e-7 of it, and the jump errs by 1e-5


class SharedCases(NamedTuple):
    """Cases of Kelvin elements that differ only in their loads and recorded steps."""

    rows: list[int]  # indices among all cases
    cases: list[Case]
    loads: np.ndarray  # Fbar, shape (cases,)
    constants: SpeedConstants  # at v1
    following: tuple[SpeedConstants, ...]  # at each v2, if its steady state is needed
    no_rates: np.ndarray  # shape (ratios,): NaN, read only


class Prepared(NamedTuple):
    """Cases for lines with a given number of steps per spacing."""

    steps_per_spacing: int
    requested: Quantities
    cases: tuple[Case, ...]
    shared: tuple[SharedCases, ...]
    separate: tuple[int, ...]  # indices of the other cases, computed one by one (memory_case.py)


def prepare(cases: Sequence[Case], steps_per_spacing: int, requested: Quantities) -> Prepared:
    """Check cases and group plain ones (Case.plain) that can be computed together.

    Raises ValueError for an invalid case, or one that double precision does not resolve.
    """
    separate: list[int] = []
    groups: dict[tuple, list[int]] = {}
    for i, case in enumerate(cases):
        _check(case, steps_per_spacing, requested)
        if case.plain:
            key = case.speed, case.scheme, case.ratios, case.refine, case.stepped
            groups.setdefault(key, []).append(i)
        else:
            separate.append(i)
    shared = (_share(rows, cases, steps_per_spacing, requested) for rows in groups.values())
    return Prepared(steps_per_spacing, requested, tuple(cases), tuple(shared), tuple(separate))


def _share(
    rows: list[int], cases: Sequence[Case], steps: int, requested: Quantities
) -> SharedCases:
    """Return the SharedCases of the cases with the indices ``rows``."""
    group = [cases[i] for i in rows]
    speed, ratios, scheme = group[0].speed, group[0].ratios, group[0].scheme
    after = tuple(ratio * speed for ratio in ratios)
    others = after if requested.jump or requested.relaxation else ()
    by_steps = group[0].stepped and requested.jump
    following = after if requested.steady or requested.relaxation or by_steps else ()
    constants = SpeedConstants.of(scheme, steps, speed, others)
    constants_after = tuple(SpeedConstants.of(scheme, steps, v2) for v2 in following)
    loads, no_rates = np.array([case.load for case in group]), np.full(len(ratios), np.nan)
    return SharedCases(rows, group, loads, constants, constants_after, no_rates)


def _check(case: Case, steps: int, requested: Quantities) -> None:
    """Raise ValueError for an invalid case."""
    speeds = [abs(speed) for speed in (case.speed, *(r * case.speed for r in case.ratios))]
    check_range("load", case.load, LOAD_LIMITS)
    for speed in speeds:
        check_range("speed", speed, SPEED_LIMITS)
    for ratio in case.ratios:
        if 0.0 < abs(ratio - 1.0) < 0.99 * MIN_RATIO_STEP:  # 0.99: admit a rounded 1e-9
            raise ValueError(f"ratio = 1 + {ratio - 1.0:g}: the step is lost in rounding")
    shortest = 1.0 / (steps * max(speeds))
    if shortest < min_step(case.spectrum):
        raise ValueError(f"speed = {max(speeds):g}: steps of {shortest:g} tau are lost in rounding")
    for kept_steps in case.kept_steps if requested.relaxation else ():
        increasing = len(kept_steps) and (kept_steps[1:] > kept_steps[:-1]).all()
        if not (increasing and kept_steps[0] >= 1):
            raise ValueError("kept_steps must hold increasing step numbers from 1 on")
