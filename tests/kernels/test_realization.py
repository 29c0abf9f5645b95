"""One realization: only what is asked for, shared work, agreement of the parts."""

import numpy as np
import pytest

from kernels import (
    SCHEMES,
    ConstantForce,
    Line,
    Quantities,
    lagged_slope,
    quadrature,
    realization,
    run_case,
    steady_sliding,
    step_average,
)
from kernels.friction import elastic_correction
from kernels.march import march
from tests.cases import ALL, CASE, ELEMENTS, KEPT, RATIOS, M, line_of
from tests.lines import random_line


def test_only_what_is_asked_for_is_computed():
    line = line_of()
    everything = run_case(line, CASE, ALL)
    steady_only = run_case(line, CASE, Quantities(jump=False, relaxation=False))
    jump_only = run_case(line, CASE, Quantities(steady=False, relaxation=False))
    assert np.all(np.isnan(steady_only.jump))
    assert np.all(np.isnan(jump_only.mu_2))
    assert steady_only.curves == jump_only.curves == []
    assert np.all(np.isfinite(everything.jump))
    assert [curve.shape for curve in everything.curves] == [KEPT.shape] * 3
    # What is asked does not depend on what else is asked.
    np.testing.assert_array_equal(jump_only.jump, everything.jump)
    np.testing.assert_array_equal(steady_only.mu_2, everything.mu_2)
    assert jump_only.work < steady_only.work < everything.work


def test_no_ratio_is_the_steady_state_alone():
    outcome = run_case(line_of(), CASE._replace(ratios=(), kept_steps=()), ALL)
    assert np.isfinite([outcome.mu_1, outcome.indentation, outcome.contact_fraction]).all()
    assert outcome.mu_2.size == outcome.jump.size == len(outcome.curves) == 0


def test_several_ratios_are_separate_runs_bit_for_bit_but_cheaper():
    line = line_of()
    together = run_case(line, CASE, ALL)
    alone = [run_case(line, CASE._replace(ratios=(r,), kept_steps=(KEPT,)), ALL) for r in RATIOS]
    assert {one.mu_1 for one in alone} == {together.mu_1}
    np.testing.assert_array_equal(together.mu_2, [one.mu_2[0] for one in alone])
    np.testing.assert_array_equal(together.jump, [one.jump[0] for one in alone])
    np.testing.assert_array_equal(together.curves, [one.curves[0] for one in alone])
    shared = run_case(line, CASE._replace(ratios=(), kept_steps=()), ALL).work
    assert together.work == sum(one.work for one in alone) - 2 * shared


@pytest.mark.parametrize("scheme", SCHEMES)
def test_outcome_is_made_of_the_kernels(scheme):
    line, v = line_of(), CASE.speed
    outcome = run_case(line, CASE._replace(scheme=scheme), ALL)
    load = CASE.load * line.z.size
    (w, d), _ = steady_sliding(SCHEMES[scheme](1.0 / (M * v)), line.z, load)
    mu, rate, contact = quadrature(line.z, line.slope, w, d, v, v, load)
    missing = elastic_correction(line.z, line.slope, w, d, v, rate, M) / load
    assert outcome.mu_1 == mu + np.exp(-((M * v) ** 2)) * missing
    assert outcome.contact_fraction == contact
    assert outcome.indentation == d + line.datum
    after, _, _ = quadrature(line.z, line.slope, w, d, v, 1.2 * v, load)
    assert outcome.jump[1] == after - mu
    swapped = run_case(line, CASE._replace(speed=1.2 * v, scheme=scheme), ALL)
    assert outcome.mu_2[1] == swapped.mu_1


@pytest.mark.parametrize("scheme", SCHEMES)
def test_curve_is_mu_2_plus_the_deviation_of_the_marched_step_average(scheme):
    line, first = line_of(), np.array([1])
    case = CASE._replace(speed=3.0, kept_steps=(first,) * 3, scheme=scheme)
    outcome, load = run_case(line, case, ALL), case.load * line.z.size
    one, two = (SCHEMES[scheme](1.0 / (M * r * case.speed)) for r in (1.0, RATIOS[0]))
    state, _ = steady_sliding(one, line.z, load)
    weight = lagged_slope(line.slope, two.lag)
    mu, *_ = march(two, ConstantForce(load), line.z, weight, state, first, np.inf)
    (w, d), _ = steady_sliding(two, line.z, load)
    deviation = mu - step_average(weight, line.z - w, d)
    assert abs(deviation[0]) > 1e-4
    # One march leaves the highest tops out, as they never touch: only rounding differs.
    np.testing.assert_allclose(outcome.curves[0] - outcome.mu_2[0], deviation, rtol=1e-9)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [1e-3, 0.1, 60.0])
def test_curve_tends_to_mu_2(scheme, load):
    kept_steps = np.array([1, 2 * ELEMENTS * M + 60])  # two turns and 30 tau
    case = CASE._replace(load=load, kept_steps=(kept_steps,) * 3, scheme=scheme)
    outcome = run_case(line_of(), case, ALL)
    for curve, mu_2 in zip(outcome.curves, outcome.mu_2, strict=True):
        assert curve[-1] == pytest.approx(mu_2, rel=1e-9, abs=1e-10)


def test_curve_is_marched_again_where_the_cap_is_exceeded(monkeypatch):
    caps = []

    def exceeded(*args):
        caps.append(args[-1])
        mu, d, passes, inside = march(*args)
        again = len(caps) % 2 == 0
        return (mu, d, passes, inside) if again else (mu + 1.0, d, passes, False)

    line, case = line_of(), CASE._replace(load=10.0)
    expected = run_case(line, case, ALL)
    monkeypatch.setattr(realization, "march", exceeded)
    outcome = run_case(line, case, ALL)
    assert len(caps) == 2 * 3
    assert set(caps[1::2]) == {1.001 * case.load * line.z.size}  # more than d can ever be
    assert min(caps) > outcome.indentation - line.datum
    np.testing.assert_array_equal(outcome.curves, expected.curves)  # not the wrong first try


BAD_CASES = [
    ({"load": 0.0}, "load"),
    ({"load": -1.0}, "load"),
    ({"load": np.nan}, "load"),
    ({"load": np.inf}, "load"),
    ({"speed": 0.0}, "speed"),
    ({"speed": -1.0}, "speed"),
    ({"speed": 1e-13}, "speed"),
    ({"speed": np.nan}, "speed"),
    ({"ratios": (0.0, 1.2, 1.5)}, "speed"),
    ({"ratios": (1.2, np.inf, 1.5)}, "speed"),
    ({"speed": 5e9}, "rounding"),  # with the ratio 1.5 and M = 2 samples per spacing
    ({"kept_steps": (np.array([0, 1]),) * 3}, "kept_steps"),
    ({"kept_steps": (KEPT, np.array([1, 5, 5]), KEPT)}, "kept_steps"),
    ({"kept_steps": (KEPT, KEPT, np.array([], int))}, "kept_steps"),
]


@pytest.mark.parametrize(("change", "named"), BAD_CASES, ids=str)
def test_cases_without_meaning_are_refused(change, named):
    with pytest.raises(ValueError, match=named):
        run_case(line_of(), CASE._replace(**change), ALL)


def test_given_samples_are_a_line_like_any_other():
    z, slope = random_line(ELEMENTS, 0.7, M, seed=1)
    given = Line.from_samples(np.roll(z, 5) + 3.0, np.roll(slope, 5), M)
    one, other = run_case(line_of(), CASE, ALL), run_case(given, CASE, ALL)
    assert other.indentation - one.indentation == pytest.approx(given.datum - line_of().datum)
    np.testing.assert_allclose(other.jump, one.jump, rtol=1e-9)
    np.testing.assert_allclose(other.curves, one.curves, rtol=1e-9, atol=1e-10)
