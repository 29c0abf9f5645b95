"""Figure 7 refined in time: the left branch belongs to implicit Euler, the right one to all."""

import numpy as np
import pytest

from tests.support.studies import rates, run

pytestmark = pytest.mark.exhaustive  # the left branch in make test: test_fig7.py

VARIANTS = ("", "euler_2", "euler_8", "euler_64", "exponential_8", "exponential_64")
VELOCITY = "grid.velocity=[4e-4, 1.25e-3, 4e-2, 4e-1]"  # x = 0.03, 0.1, 3, 31


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """Return some groups of the study."""
    folder = tmp_path_factory.mktemp("refinement")
    return run(folder, "refinement", VELOCITY, variants=VARIANTS)


@pytest.mark.parametrize("m", [8, 64])
def test_left_branch_is_the_decay_of_implicit_euler(groups, m):
    """b = ln(1 + dt)/dt: what a factor 1/(1 + dt) per step amounts to."""
    data = groups[f"euler_{m}"]
    x, rate = rates(data, 0.0, 0.2)
    error = rates(data.assign(relaxation_rate=data.relaxation_rate_error), 0.0, 0.2)[1]
    dt = np.pi / (1.2 * m * x)
    expected = np.log1p(dt) / dt
    assert x.size >= 4
    assert (np.abs(rate - expected) < 0.06 * expected + 3.0 * error).all()
    assert (error < 0.1 * expected).all()


def test_exponential_scheme_has_no_left_branch_at_any_m(groups):
    for m in (8, 64):
        x, rate = rates(groups[f"exponential_{m}"], 0.0, 0.2)
        assert x.size >= 1
        assert np.abs(rate - 1.0).max() < 0.1


def test_schemes_meet_above_one(groups):
    fast = {"velocity": slice(2, None)}
    limit = groups[""].relaxation_rate.isel(fast)
    for name in ("euler_64", "exponential_64"):
        ratio = groups[name].relaxation_rate.isel(fast) / limit
        np.testing.assert_allclose(ratio, 1.0, atol=0.15)
