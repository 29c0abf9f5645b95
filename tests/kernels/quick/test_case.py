"""Cases: which of them take the quick path of a Kelvin element."""

import numpy as np
import pytest

from elastomer_friction.kernels.quick.case import Case, PhaseClock, PhaseClocks, Quantities, Seconds
from elastomer_friction.kernels.rheology.spectrum import Spectrum

PLAIN = Case(0.1, 1.0, (1.2, 0.5), (np.array([1]),), "exponential")


@pytest.mark.parametrize(
    "changed", [{"speed": -1.0}, {"ratios": (-1.2,)}, {"spectrum": Spectrum((1.0,), (1.0,), 0.0)}]
)
def test_a_kelvin_element_that_slides_one_way_is_plain(changed):
    assert PLAIN.plain
    assert not PLAIN._replace(**changed).plain


def test_without_a_quantity_no_steady_state_is_needed():
    assert not Quantities(steady=False, jump=False, relaxation=False).anything
    for name in ("steady", "jump", "relaxation", "initial_rate"):
        nothing = dict.fromkeys(("steady", "jump", "relaxation"), False)
        assert Quantities(**{**nothing, name: True}).anything


def test_a_clock_books_time_to_its_phases():
    clock = PhaseClock()
    clock.lap("jump")
    assert set(clock.spent) == set(Seconds._fields)
    assert clock.spent["steady"] == 0.0 <= clock.spent["jump"]


def test_clocks_book_time_by_work_or_to_one_case_alone():
    clocks = PhaseClocks(2)
    clocks.lap(steady=[1.0, 3.0])
    first, second = (clocks.seconds(case).steady for case in range(2))
    assert second == pytest.approx(3.0 * first)
    clocks.lap_alone(1, jump=2.0, marching=6.0)
    assert clocks.seconds(0) == (first, 0.0, 0.0)
    assert clocks.seconds(1).marching == pytest.approx(3.0 * clocks.seconds(1).jump)
