"""What the foundation gives of a half-space: read from a table, and not said beyond it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.plan import ratio_of_bodies as module
from elastomer_friction.workflow.plan.problems import line_slope
from elastomer_friction.workflow.plan.ratio_of_bodies import model_ratio, place_of
from elastomer_friction.workflow.simulate.tasks import LineShape, Problem

HEAD = "kind,waves,hurst,load,speed_ratio,ratio,error\n"


def law(waves, hurst, load, x):
    """A ratio whose logarithm is linear in what the table is linear in."""
    return math.exp(0.1 * hurst + 0.2 * math.log(waves) - 0.3 * math.log(load) + 0.05 * math.log(x))


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    rows = [
        f"kelvin,{w},{h},{f},{x},{law(w, h, f, x):.12g},{0.1 * law(w, h, f, x):.12g}\n"
        for w in (4.0, 16.0)
        for h in (0.0, 0.8)
        for f in (0.01, 0.1, 1.0)
        for x in (0.1, 1.0, 10.0)
    ]
    file = tmp_path_factory.mktemp("table") / "ratio_of_bodies.csv"
    file.write_text(HEAD + "".join(rows))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "TABLE", file)
        module._table.cache_clear()
        yield
    module._table.cache_clear()


def problem_at(waves, hurst, load, x, body):
    """Return the problem of a place, on a surface of two longest waves."""
    elements = 4 * waves
    shape = LineShape(rolloff=2.0, body=body)
    slope = line_slope(Problem(hurst, elements, 1.0, 1.0, 1.0, surface=shape))
    shared = 1.0 if body == "half-space" else 2.0
    pressed = load * slope * elements / shared
    return Problem(hurst, elements, pressed, x / math.pi, 1.2, surface=shape)


@pytest.mark.usefixtures("table")
@given(
    waves=st.integers(4, 16),
    hurst=st.floats(0.0, 0.8),
    load=st.floats(0.0101, 0.99),
    x=st.floats(0.101, 9.9),
    body=st.sampled_from(["foundation", "half-space"]),
)
def test_between_the_points_it_is_what_the_table_is_made_of(waves, hurst, load, x, body):
    found, error = model_ratio(problem_at(waves, hurst, load, x, body))
    assert found == pytest.approx(law(waves, hurst, load, x), rel=1e-9)
    assert error == pytest.approx(0.1 * found, rel=1e-9)


@pytest.mark.usefixtures("table")
@pytest.mark.parametrize(
    "place", [(3, 0.4, 0.1, 1.0), (8, 0.9, 0.1, 1.0), (8, 0.4, 2.0, 1.0), (8, 0.4, 0.1, 0.05)]
)
def test_outside_nothing_is_said(place):
    assert all(map(math.isnan, model_ratio(problem_at(*place, "half-space"))))


def test_one_nominal_pressure_is_one_place_on_both_bodies():
    on_map, on_line = (problem_at(8, 0.4, 0.1, 1.0, body) for body in ("half-space", "foundation"))
    assert on_line.load != on_map.load
    assert place_of(on_map)[1:] == pytest.approx(place_of(on_line)[1:])
