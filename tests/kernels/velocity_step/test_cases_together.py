"""Many cases, on one line or several: no outcome depends on the others, to the bit."""

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
from tests.cases import ALL, CASE, KEPT, bits, line_of

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


def run_alone(cases, requested):
    """Return the bits of the outcomes of cases that are run one by one."""
    return [bits(run_case(LINE, case, requested)) for case in cases]


ALONE = run_alone(CASES, STEADY)


@settings(max_examples=20)
@given(st.permutations(range(len(CASES))), st.integers(1, len(CASES)))
def test_other_cases_and_their_order_change_no_bit(order, count):
    part = order[:count]
    together = run_cases(LINE, [CASES[i] for i in part], STEADY)
    assert [bits(outcome) for outcome in together] == [ALONE[i] for i in part]


def test_one_bad_case_is_refused():
    with pytest.raises(ValueError, match="load"):
        run_cases(LINE, [CASE, CASE._replace(load=-1.0)], STEADY)


MEMORY = CASE._replace(
    ratios=(1.2,), kept_steps=(KEPT[:3],), spectrum=Spectrum((1.0,), (1.0,), 0.1)
)
STEADY_ONLY = Quantities(jump=False, relaxation=False)


def test_cases_of_one_speed_are_shared_and_those_with_memory_are_separate():
    faster, heavier = CASE._replace(speed=2.0 * CASE.speed), CASE._replace(load=2.0 * CASE.load)
    prepared = prepare([CASE, MEMORY, faster, heavier], 4, STEADY_ONLY)
    assert [shared.rows for shared in prepared.shared] == [[0, 3], [2]]
    assert prepared.separate == (1,)
    np.testing.assert_array_equal(prepared.shared[0].loads, [CASE.load, heavier.load])


@pytest.mark.parametrize(
    "requested", [ALL, STEADY_ONLY, ALL._replace(jump=False), ALL._replace(indentation_rate=False)]
)
def test_lines_run_together_equal_lines_run_alone(requested):
    cases = [CASE, CASE._replace(load=1e-3, speed=100.0), CASE._replace(load=40.0), MEMORY]
    lines = [line_of(shift=shift, steps=4) for shift in (0.0, 3.3, 20.2)]
    together = run_prepared(lines, prepare(cases, 4, requested))
    for line, outcomes in zip(lines, together, strict=True):
        assert list(map(bits, outcomes)) == list(map(bits, run_cases(line, cases, requested)))


@pytest.mark.parametrize(
    "lines",
    [
        [line_of(steps=4)],
        [line_of(steps=8), line_of(steps=4)],
        [line_of(60, steps=8), line_of(62, steps=8)],
        [line_of(steps=8), line_of(steps=8)._replace(band_limited=False)],
    ],
)
def test_lines_unlike_the_prepared_ones_are_refused(lines):
    with pytest.raises(ValueError, match="alike, of 8 steps per spacing"):
        run_prepared(lines, prepare([CASE], 8, STEADY_ONLY))
