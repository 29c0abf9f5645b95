"""Cases that are prepared once for many lines."""

import numpy as np
import pytest

from kernels import Quantities, Spectrum, prepare, run_cases, run_prepared
from tests.cases import ALL, CASE, line_of

MEMORY = CASE._replace(ratios=(), kept_steps=(), spectrum=Spectrum((1.0,), (1.0,), 0.1))
STEADY = Quantities(jump=False, relaxation=False)


def test_cases_of_one_speed_are_together_and_those_with_memory_alone():
    faster, heavier = CASE._replace(speed=2.0 * CASE.speed), CASE._replace(load=2.0 * CASE.load)
    found = prepare([CASE, MEMORY, faster, heavier], 4, STEADY)
    assert [some.rows for some in found.together] == [[0, 3], [2]]
    assert found.alone == (1,)
    np.testing.assert_array_equal(found.together[0].loads, [CASE.load, heavier.load])


@pytest.mark.parametrize("asked", [ALL, STEADY, ALL._replace(jump=False)])
def test_what_is_prepared_gives_on_every_line_what_cases_give(asked):
    narrow = CASE._replace(load=1e-3, speed=100.0)
    found = prepare([CASE, narrow], 4, asked)
    for shift in (0.0, 3.3):
        line = line_of(shift=shift, steps=4)
        for one, other in zip(
            run_prepared(line, found), run_cases(line, [CASE, narrow], asked), strict=True
        ):
            for name in one._fields[:-2]:
                np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


def test_a_line_of_other_steps_is_refused():
    with pytest.raises(ValueError, match="not the 8 prepared for"):
        run_prepared(line_of(steps=4), prepare([CASE], 8, STEADY))
