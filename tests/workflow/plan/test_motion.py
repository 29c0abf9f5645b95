"""The programme of a scene without units: rounding, similarity, and what a hold list makes."""

import pytest

from elastomer_friction.kernels import Hold, Slide
from elastomer_friction.workflow.plan.motion import rounded
from elastomer_friction.workflow.plan.problems import distinct_problems
from tests.support.small import keys, small_plan, small_study

PROGRAMME = (
    "scene.programme=[{slide={ratio=1.0, distance=1e-3}}, {hold={duration=[1e-3, 1e-2]}}, "
    "{slide={ratio=2.0, distance=1e-3}}]"
)
TEXT = """
[study]
seed = 1
realizations = 4
[material]
shear_modulus = 1e7
branches = [[2e7, 1e-3]]
wlf = {c1 = 10.0, c2 = 50.0, reference = 20.0}
temperature = [10.0, 20.0]
[surface]
length = 0.01
[grid]
hurst = 0.5
normal_force = 0.04
spacing = 1e-4
roughness = 1e-5
velocity = [0.03, 9.486832980505138]
[scene]
quantities = ["steady", "trace"]
"""


def programmes(text, *settings):
    """Return the distinct problems of a study and the index of each point."""
    return distinct_problems(small_study(*settings, text=text))


def test_lengths_are_in_spacings_and_times_in_tau():
    found, index = programmes(TEXT, PROGRAMME, "material.temperature=20.0", "grid.velocity=0.03")
    assert index.shape == (1, 1, 1, 1, 1, 1, 2)
    tau = 2e-3
    for problem, hold in zip(found, (1e-3, 1e-2), strict=True):
        first, held, last = problem.programme
        assert first == Slide(rounded(0.03 * tau / 1e-4), 10.0)
        assert held == Hold(rounded(hold / tau))
        assert last.speed == rounded(0.06 * tau / 1e-4)
        assert problem.speed == first.speed


def test_a_temperature_is_a_velocity_so_that_points_are_one_problem():
    """log10 a_T = 2.5 at 10 °C: 0.03 m/s there is 9.49 m/s at 20 °C, slide by slide."""
    found, index = programmes(TEXT, "scene.programme=[{slide={ratio=1.0, distance=1e-3}}]")
    assert index.size == 4
    assert len(found) == 3


def test_material_and_programme_enter_the_key():
    plans = [
        small_plan(*settings, text=TEXT)
        for settings in (
            (PROGRAMME,),
            (PROGRAMME.replace("1e-2", "2e-2"),),
            (PROGRAMME, "material.branches=[[2e7, 2e-3]]"),
            (PROGRAMME, "scene.repeat=2"),
            (PROGRAMME, 'numerics.record="log"'),
        )
    ]
    found = [set(keys(plan)) for plan in plans]
    assert found[0] & found[1]  # the hold that both have
    for other in found[2:]:
        assert found[0].isdisjoint(other)


def test_branches_in_any_order_are_one_material():
    orders = "[[2e7, 1e-3], [1e7, 1e-4]]", "[[1e7, 1e-4], [2e7, 1e-3]]"
    one, two = (small_plan(PROGRAMME, f"material.branches={order}", text=TEXT) for order in orders)
    assert keys(one) == keys(two)


@pytest.mark.parametrize("value", [0.1, 1e-300, 3.0])
def test_rounding_is_to_twelve_digits(value):
    assert rounded(value) == pytest.approx(value, rel=1e-12)
    assert rounded(rounded(value) * (1.0 + 1e-14)) == rounded(value)
