"""The study of accuracy: its parts against what is known of them, and the study as a whole."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    Line,
    lagged_slope,
    march,
    steady_sliding,
    step_average,
)
from elastomer_friction.studies.accuracy.alternatives import MARCHES
from elastomer_friction.studies.accuracy.measure import table
from elastomer_friction.studies.accuracy.points import Point, surface
from elastomer_friction.studies.accuracy.recommendation import cheapest
from elastomer_friction.studies.accuracy.sampling import Method, run_lines
from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.simulate import Problem
from tests.support.studies import check_drawing, load
from tests.tools.wide import mean_of_lines, stated

whole_study = pytest.mark.exhaustive  # its parts are asked for in make test
POINT = Point(0.5, 0.3, 1.5)
TOLERANCE = {"numpy": 1e-8, "tamaas": 1e-6}


def kernel_march(line, point, steps):
    """Return steady friction at v1 and that of steps after the jump, by the kernels."""
    load = point.load * line.z.size
    dt = 1.0 / (line.steps_per_spacing * point.speed)
    one, two = SCHEMES["implicit-euler"](dt), SCHEMES["implicit-euler"](dt / 1.2)
    state, _ = steady_sliding(one, line.z, load)
    weight = lagged_slope(line.slope, 0.0)
    steady = step_average(weight, line.z - state.w, state.d)
    record = np.arange(1, steps + 1)
    mu, *_ = march(two, ConstantForce(load), line.z, weight, state, record, np.inf)
    return steady, mu, dt


@pytest.mark.parametrize("name", MARCHES)
@pytest.mark.parametrize("m", [1, 4])
def test_alternatives_agree_with_the_kernels_at_equal_m(name, m):
    if name == "tamaas":
        pytest.importorskip(name)
    line = Line.self_affine(*surface(POINT, 100, 1, 0), m)
    steady, mu, dt = kernel_march(line, POINT, 10)
    one = MARCHES[name](line, POINT.load)
    before = one.advance(int(np.ceil(25.0 / np.log1p(dt))), dt)
    assert before[-1] == pytest.approx(steady, rel=TOLERANCE[name])
    np.testing.assert_allclose(one.advance(10, dt / 1.2), mu, rtol=TOLERANCE[name])


def test_straight_lines_between_samples_relax_too_slowly_and_the_stated_bias_says_so():
    problem = Problem(0.6, 1000, 0.2, 6.0, 1.2)  # wide contacts, short steps
    coarse, finer, limit = (mean_of_lines(problem, m, 64, 1) for m in (4, 8, 32))
    error, less = coarse[2] / limit[2] - 1.0, finer[2] / limit[2] - 1.0
    bound = stated(problem, 4, coarse)[2]
    assert -bound < error < -0.4 * bound
    assert abs(less) < min(0.5 * abs(error), stated(problem, 8, finer)[2])


def test_a_narrow_contact_is_right_at_four_samples_if_it_is_refined_and_not_otherwise():
    point = Point(0.7, 1e-3, 100.0)
    lines = [surface(point, 200, 1, index) for index in range(4)]
    limit, refined, plain = (
        run_lines(point, lines, Method("exponential", *how)).mu_1
        for how in ((64,), (4,), (4, False))
    )
    assert (abs(refined / limit - 1.0) < 0.02).all()
    assert (abs(plain / limit - 1.0) > 0.05).any()


def test_choice_balances_bias_and_realizations():
    ladder = ("point", "scheme", "steps")
    bias = np.tile([[0.1], [0.02], [-0.005]], (1, 1, 1, 3))
    data = xr.Dataset(
        {
            "bias": ((*ladder, "quantity"), bias),
            "bias_error": ((*ladder, "quantity"), 0.0 * bias),
            "seconds": ((*ladder, "part"), np.tile([[1.0], [2.0], [4.0]], (1, 1, 1, 2))),
            "deviation": (("point", "quantity"), [[0.5, 1e-6, np.nan]]),
        },
        {"quantity": ["mu_1", "jump", "rate"], "steps": [1, 2, 4], "part": [0, 1]},
    )
    actual = cheapest(data.assign_coords(target=[0.2, 0.01, 0.004])).isel(point=0)
    mu_1 = actual.sel(sampled="mu_1")
    np.testing.assert_array_equal(mu_1.steps, [1, 4, np.nan])
    assert mu_1.realizations[1] == np.ceil(0.25 / (1e-4 - 2.5e-5))
    assert actual.realizations.sel(sampled="jump")[0] == 10
    assert actual.sel(sampled="rate").steps.isnull().all()


@pytest.fixture(scope="module")
def groups(tmp_path_factory):
    """Run the study at smoke scale; return the groups of its result."""
    folder = tmp_path_factory.mktemp("accuracy")
    assert main(["run", "accuracy", "--scale", "smoke", "--out", str(folder)]) == 0
    return load(folder / "accuracy-smoke.nc")


@whole_study
def test_both_schemes_converge_to_one_reference(groups):
    data = groups[""]
    for quantity, share in (("mu_1", 0.1), ("curve", 0.2)):
        error = data.error.sel(quantity=quantity)
        assert (error.sel(steps=16) < share * error.sel(steps=1)).all()
        assert (data.reference_error.sel(quantity=quantity) < 0.01).all()
    assert (data.seconds.dropna("steps", how="all") > 0.0).any()


@whole_study
def test_refining_narrow_contacts_begins_at_four_samples_and_pays_there(groups):
    """In the median; what is coarser is as sampled anyway."""
    refined = groups[""].error.sel(scheme="exponential", quantity=["mu_1", "jump"])
    plain = groups["as_sampled"].error.sel(quantity=["mu_1", "jump"])
    coarse = {"steps": [1, 2]}
    np.testing.assert_array_equal(plain.sel(coarse), refined.sel(coarse))
    ratio = (plain / refined).sel(steps=4).median("point")
    assert (ratio >= 1.0).all()
    assert ratio.max() > 1.5


@whole_study
def test_refinement_moves_a_curve_with_the_steady_friction_it_ends_at_and_leaves_the_rate(groups):
    refined = groups[""].error.sel(scheme="exponential")
    plain = groups["as_sampled"].error
    one, other = (each.sel(quantity="rate") for each in (refined, plain))
    np.testing.assert_allclose(other, one, rtol=1e-6, atol=1e-9)
    worst = [each.sel(quantity="curve", steps=4).max("point") for each in (plain, refined)]
    assert worst[0] > worst[1]


@whole_study
def test_recommendation_asks_more_for_more_accuracy(groups):
    count = groups["recommendation"].realizations.sel(sampled="mu_1")
    coarse, fine = count.sel(target=0.1), count.sel(target=0.01)
    both = np.isfinite(coarse) & np.isfinite(fine)
    assert both.any()
    assert (fine > coarse).where(both, True).all()


@whole_study
def test_figure_and_table(groups):
    check_drawing("accuracy", groups)
    rows = table(groups)
    assert [*rows.columns[:3]] == ["point", "sampled", "target"]
    assert len(rows) > 4
