"""Reduction of block means to estimates, against the formulas written out with numpy."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.goal import JACKKNIFE_GROUPS
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.simulate.tasks import SCALARS
from tests.support.curves import RATE, exponential_blocks

BLOCKS = exponential_blocks()
FOUND = reduce_blocks(BLOCKS)
COUNT = BLOCKS.scalars.shape[1]


VALUES = dict(zip(SCALARS, np.moveaxis(BLOCKS.scalars, 2, 0), strict=True))
VALUES = {name: values for name, values in VALUES.items() if name in FOUND}
START = VALUES["mu_1"] + VALUES["jump"]  # just after the jump
VALUES["mu"] = np.concatenate([START[..., None], BLOCKS.values["curve"]], axis=2)
VALUES["deviation"] = VALUES["mu"] - VALUES["mu_2"][..., None]


@pytest.mark.parametrize("name", VALUES)
def test_estimate_is_the_mean_and_its_error_the_classical_one(name):
    values = VALUES[name]
    np.testing.assert_allclose(FOUND[name], values.mean(axis=1), rtol=1e-12, atol=1e-14)
    classical = values.std(axis=1, ddof=1) / np.sqrt(COUNT)
    np.testing.assert_allclose(FOUND[f"{name}_error"], classical, rtol=1e-6, atol=1e-14)


def test_degrees_of_freedom_are_one_less_than_the_blocks():
    assert FOUND["degrees_of_freedom"].tolist() == [COUNT - 1] * 3


def test_curve_starts_just_after_the_jump():
    assert FOUND["time"][:, 0].tolist() == [0.0] * 3
    assert np.array_equal(FOUND["time"][:, 1:], BLOCKS.time, equal_nan=True)


def test_rate_of_each_task_is_found_with_mu_2_known_and_free():
    assert FOUND["fit_status"].tolist() == [FITTED] * 3
    expected = RATE * np.array([1.0, 2.0, 3.0])
    np.testing.assert_allclose(FOUND["relaxation_rate"], expected, rtol=1e-6)
    np.testing.assert_allclose(FOUND["relaxation_rate_free"], expected, rtol=1e-5)


def test_amplitude_varies_as_the_curves_do():
    shares = VALUES["deviation"][0, :, 1] * np.exp(RATE * BLOCKS.time[0, 0])
    assert FOUND["amplitude"][0] == pytest.approx(shares.mean(), rel=1e-6)
    error = shares.std(ddof=1) / np.sqrt(COUNT)
    assert FOUND["amplitude_error"][0] == pytest.approx(error, rel=1e-4)


def test_replicates_of_the_rate_are_handed_on():
    assert FOUND["rate_replicates"].shape == (3, JACKKNIFE_GROUPS + 1)
    assert np.array_equal(FOUND["rate_replicates"][:, 0], FOUND["relaxation_rate"])


NAMES = {
    "steady": {"mu_1", "mu_2", "indentation", "contact_fraction"},
    "jump": {"jump"},
    "relaxation": {"mu", "deviation", "relaxation_rate", "relaxation_rate_free", "amplitude"},
    "models": {
        *("stretched_rate", "stretched_exponent", "fast_rate", "slow_rate", "fast_share"),
        *("gain_stretched", "gain_two_exponentials"),
    },
}
WITHOUT_ERROR = {"time", "fit_status", "fit_window", "fit_quality", "rate_replicates"}
SCENES = [("steady",), ("jump",), ("relaxation",), ("steady", "jump"), tuple(NAMES)]


@pytest.mark.parametrize("asked", SCENES)
def test_only_what_was_asked_for_is_there(asked):
    names = {"samples_per_contact"}.union(*(NAMES[quantity] for quantity in asked))
    expected = names | {f"{name}_error" for name in names} | {"degrees_of_freedom"}
    if "relaxation" in asked:
        expected |= WITHOUT_ERROR
    if "models" in asked:
        expected |= {"best_model"}
    assert set(reduce_blocks(exponential_blocks(quantities=asked))) == expected


def test_reduction_does_not_depend_on_the_company_of_a_task():
    alone = reduce_blocks(
        BLOCKS._replace(
            scalars=BLOCKS.scalars[1:2],
            values={"curve": BLOCKS.values["curve"][1:2]},
            time=BLOCKS.time[1:2],
            rms_slope=BLOCKS.rms_slope[1:2],
        )
    )
    for name, values in alone.items():
        assert values.tobytes() == FOUND[name][1:2].tobytes()
