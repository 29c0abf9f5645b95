"""The tables [numerics] and [compare.NAME]: what is left out, inherited, refused."""

from elastomer_friction.workflow.study.numerics import Numerics
from tests.support.small import small_study


def test_below_one_percent_the_march_is_longer_unless_a_horizon_is_given():
    settings = (), ("numerics.accuracy=0.01",), ("numerics.accuracy=0.005",)
    horizons = [small_study(*some).variants[""].horizon for some in settings]
    assert horizons == [4.0, 4.0, 6.0]
    given = small_study("numerics.accuracy=0.005", "numerics.horizon=3")
    assert given.variants[""].horizon == 3.0


def test_comparison_inherits_the_numerics_it_does_not_name():
    coarse = small_study("numerics.horizon=7.0").variants["coarse"]
    assert coarse == Numerics("implicit-euler", 1, 16, 7.0)


def test_automatic_steps_are_kept_as_a_question():
    assert small_study("numerics.steps_per_spacing=auto").variants[""].steps_per_spacing is None
