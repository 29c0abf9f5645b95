"""Many cases, on one line or several: what one gives does not depend on its company, to the bit."""

from itertools import count

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import (
    Quantities,
    Spectrum,
    prepare,
    run_case,
    run_cases,
    run_prepared,
)
from elastomer_friction.kernels.quick import case as clocks
from elastomer_friction.kernels.quick import cases as module
from tests.cases import ALL, CASE, KEPT, line_of

LINE = line_of()
STEADY = Quantities(relaxation=False)
SOLID = Spectrum((8.0,), (0.125,), 0.0)
CASES = [
    *(CASE._replace(load=load) for load in np.geomspace(1e-4, 30.0, 20)),
    *(CASE._replace(load=load, speed=3.0) for load in (0.01, 0.3)),
    CASE._replace(scheme="implicit-euler"),
    CASE._replace(ratios=(1.0,), kept_steps=CASE.kept_steps[:1]),
    CASE._replace(spectrum=SOLID),
]


def numbers(outcome):
    """Return what an outcome holds, without the time it took, as bytes."""
    fields = outcome._replace(seconds=None)._asdict()
    return {name: np.asarray(value).tobytes() for name, value in fields.items()}


def alone(cases, asked):
    return [numbers(run_case(LINE, case, asked)) for case in cases]


ALONE = alone(CASES, STEADY)


@settings(max_examples=20)
@given(st.permutations(range(len(CASES))), st.integers(1, len(CASES)))
def test_company_and_order_change_no_bit(order, count):
    part = order[:count]
    together = run_cases(LINE, [CASES[i] for i in part], STEADY)
    assert [numbers(found) for found in together] == [ALONE[i] for i in part]


def test_company_changes_no_bit_of_a_relaxation():
    cases = CASES[::6]
    together = run_cases(LINE, cases, Quantities())
    assert [numbers(found) for found in together] == alone(cases, Quantities())


def test_no_case_is_no_work():
    assert run_cases(LINE, [], STEADY) == []


def test_one_bad_case_is_refused():
    with pytest.raises(ValueError, match="load"):
        run_cases(LINE, [CASE, CASE._replace(load=-1.0)], STEADY)


def test_time_is_booked_to_the_cases_that_took_it(monkeypatch):
    """By a clock that goes on by one when it is read, and by every element that a march updates."""
    readings, updated, march = count(1.0), [0.0], module._curves

    def marched(*how):
        found, updates = march(*how)
        updated[0] += float(updates.sum())
        return found, updates

    monkeypatch.setattr(module, "_curves", marched)
    monkeypatch.setattr(clocks, "computing_seconds", lambda: next(readings) + updated[0])
    found = run_cases(LINE, CASES[:20], Quantities())
    assert found[0].seconds.marching > found[-1].seconds.marching
    assert found[-1].seconds.steady > 0.0  # of the line, that all share


MEMORY = CASE._replace(
    ratios=(1.2,), kept_steps=(KEPT[:3],), spectrum=Spectrum((1.0,), (1.0,), 0.1)
)
STEADY_ALONE = Quantities(jump=False, relaxation=False)


def test_cases_of_one_speed_are_together_and_those_with_memory_alone():
    faster, heavier = CASE._replace(speed=2.0 * CASE.speed), CASE._replace(load=2.0 * CASE.load)
    found = prepare([CASE, MEMORY, faster, heavier], 4, STEADY_ALONE)
    assert [some.rows for some in found.together] == [[0, 3], [2]]
    assert found.alone == (1,)
    np.testing.assert_array_equal(found.together[0].loads, [CASE.load, heavier.load])


@pytest.mark.parametrize("asked", [ALL, STEADY_ALONE, ALL._replace(jump=False)])
def test_lines_run_together_give_what_each_gives_alone(asked):
    cases = [CASE, CASE._replace(load=1e-3, speed=100.0), CASE._replace(load=40.0), MEMORY]
    lines = [line_of(shift=shift, steps=4) for shift in (0.0, 3.3, 20.2)]
    together = run_prepared(lines, prepare(cases, 4, asked))
    for line, found in zip(lines, together, strict=True):
        for one, other in zip(found, run_cases(line, cases, asked), strict=True):
            for name in set(one._fields) - {"seconds"}:
                np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


@pytest.mark.parametrize(
    "lines",
    [
        [line_of(steps=4)],
        [line_of(steps=8), line_of(steps=4)],
        [line_of(60, steps=8), line_of(62, steps=8)],
        [line_of(steps=8), line_of(steps=8)._replace(band_limited=False)],
    ],
)
def test_lines_that_cases_are_not_prepared_for_are_refused(lines):
    with pytest.raises(ValueError, match="alike, of 8 steps per spacing"):
        run_prepared(lines, prepare([CASE], 8, STEADY_ALONE))
