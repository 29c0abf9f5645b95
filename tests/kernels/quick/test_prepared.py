"""Cases that are prepared once for many lines."""

import numpy as np
import pytest

from elastomer_friction.kernels import Quantities, Spectrum, prepare, run_cases, run_prepared
from tests.cases import ALL, CASE, KEPT, line_of

MEMORY = CASE._replace(
    ratios=(1.2,), kept_steps=(KEPT[:3],), spectrum=Spectrum((1.0,), (1.0,), 0.1)
)
STEADY = Quantities(jump=False, relaxation=False)


def test_cases_of_one_speed_are_together_and_those_with_memory_alone():
    faster, heavier = CASE._replace(speed=2.0 * CASE.speed), CASE._replace(load=2.0 * CASE.load)
    found = prepare([CASE, MEMORY, faster, heavier], 4, STEADY)
    assert [some.rows for some in found.together] == [[0, 3], [2]]
    assert found.alone == (1,)
    np.testing.assert_array_equal(found.together[0].loads, [CASE.load, heavier.load])


@pytest.mark.parametrize("asked", [ALL, STEADY, ALL._replace(jump=False)])
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
        run_prepared(lines, prepare([CASE], 8, STEADY))
