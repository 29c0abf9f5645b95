"""Verdicts: a deviation, its error and a tolerance become plain words."""

import numpy as np

from elastomer_friction.workflow.reduce import RESOLVED, UNRESOLVED
from elastomer_friction.workflow.report.claims import (
    evaluate,
    judge,
    judge_factor,
    known_claims,
    mean_error,
)
from tests.support.synthetic import result, with_alpha, with_rates

CLAIMS = known_claims()


def test_claims_without_their_study_are_left_out():
    assert evaluate(CLAIMS, {}) == []
    assert evaluate(CLAIMS, {"fig7": result()}) == []  # no estimates at all
    dataset = result()
    both = with_alpha(with_rates(dataset, dataset.speed_ratio), 1.0 - dataset.hurst)
    found = evaluate(CLAIMS, {"fig7": both})
    assert 0 < len(found) < len(CLAIMS)
    assert all(text for claim in found for text in claim)


def test_claims_leave_unresolved_points_out_and_say_how_many():
    dataset = result()
    dataset = with_rates(dataset, dataset.speed_ratio ** (1.0 - dataset.hurst))
    status = np.full(dataset.rms_slope.shape, RESOLVED, np.int8)
    status.flat[-3:] = UNRESOLVED  # the fastest of the smooth line
    wrong = dataset.relaxation_rate.where(status != UNRESOLVED, 1e3)
    spoilt = dataset.assign(
        relaxation_rate=wrong, resolution_status=(dataset.rms_slope.dims, status)
    )
    sound = {claim.text: claim.found for claim in evaluate(CLAIMS, {"fig7": dataset})}
    found = {claim.text: claim.found for claim in evaluate(CLAIMS, {"fig7": spoilt})}
    assert len(found) == len(sound) > 0
    said = "; 3 points left out, whose contacts are unresolved"
    assert all(text.endswith(said) for text in found.values())
    assert not any("left out" in text for text in sound.values())
    assert not any("1e+03" in text or "1000" in text for text in found.values())


def test_deviations_within_two_errors_are_chance():
    assert judge(0.05, 0.03) == "holds"
    assert judge(0.05, 0.02) == "holds within 5 %"
    assert judge(0.05, 0.2) == "cannot be told: the error is too large"
    assert judge(np.nan) == "cannot be told: the error is too large"
    assert judge_factor(np.array([0.5, 2.0])) == "holds within a factor 2"


def test_errors_of_points_on_the_same_lines_do_not_average_out():
    error = result().speed_ratio * 0.0 + 0.1  # 2 H, one spacing, 14 points each
    np.testing.assert_allclose(mean_error(error), 0.1 / np.sqrt(2.0))
    np.testing.assert_allclose(mean_error(error.isel(hurst=[0])), 0.1)
