"""One realization: shared work, agreement of its parts, and refused cases."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities, run_case, run_cases
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    FOLLOWED_SAMPLES,
    LineSet,
    SpeedConstants,
    steady_friction,
)
from elastomer_friction.kernels.quick.march.active import active_march
from elastomer_friction.kernels.rheology.spectrum import Spectrum
from elastomer_friction.kernels.velocity_step import cases
from tests.cases import ALL, CASE, KEPT, RATIOS, line_of


def test_contacts_are_followed_only_on_request():
    line, requested = line_of(steps=4), Quantities(relaxation=False)
    given = CASE._replace(load=1e-3, speed=100.0, refine=False)
    finer = given._replace(refine=True)
    as_sampled, refined = run_case(line, given, requested), run_case(line, finer, requested)
    constants = SpeedConstants.of(given.scheme, line.steps_per_spacing, 100.0)
    alone = steady_friction(LineSet.of([line]), constants, np.array([1e-3 * line.z.size]))
    assert as_sampled.mu_1 == alone.mu[0, 0] > 0.0
    assert as_sampled.samples_per_contact == alone.samples[0, 0] < 0.5 * FOLLOWED_SAMPLES
    assert refined.samples_per_contact >= FOLLOWED_SAMPLES
    together = run_cases(line, [given, finer], requested)
    assert [one.mu_1 for one in together] == [as_sampled.mu_1, refined.mu_1]


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


def test_curve_is_marched_plainly_where_bounds_are_exceeded(monkeypatch):
    def beyond_bounds(*args):
        mu, d, settled, work, _ = active_march(*args)
        return mu + 2.0, d, settled, work, False

    line, case = line_of(), CASE._replace(load=1.0)
    usual = run_case(line, case, ALL)
    monkeypatch.setattr(cases, "active_march", beyond_bounds)
    outcome = run_case(line, case, ALL)
    assert outcome.work > usual.work
    # The first result is dropped; the plain march visits more samples and rounds differently.
    np.testing.assert_allclose(outcome.curves, usual.curves, rtol=1e-12)


def test_the_indentation_rate_affects_only_the_relaxation():
    line = line_of()
    full = run_case(line, CASE, ALL)
    without = run_case(line, CASE, Quantities(indentation_rate=False))
    np.testing.assert_array_equal(without.mu_2, full.mu_2)
    np.testing.assert_array_equal(without.jump, full.jump)
    assert not np.allclose(without.curves, full.curves, rtol=1e-3, atol=0.0)


BAD_CASES = [
    *[({"load": value}, "load") for value in (0.0, -1.0, np.nan, np.inf)],
    *[({"speed": value}, "speed") for value in (0.0, 1e-13, np.nan)],
    *[({"ratios": ratios}, "speed") for ratios in ((0.0, 1.2, 1.5), (1.2, np.inf, 1.5))],
    ({"speed": 5e9}, "rounding"),  # with the ratio 1.5 and M = 2 samples per spacing
    ({"ratios": (1.0, 1.0 + 1e-11, 1.2)}, "rounding"),
    *[({"kept_steps": (KEPT, np.array(bad, int), KEPT)}, "steps") for bad in ([0, 1], [5, 5], [])],
]


def test_the_jump_is_proportional_to_the_step_down_to_the_smallest():
    requested = Quantities(relaxation=False)
    steps = np.array([1e-9, 1e-6, 1e-4])
    jump = run_case(line_of(), CASE._replace(ratios=(*(1.0 + steps),)), requested).jump
    np.testing.assert_allclose(jump / steps, jump[-1] / steps[-1], rtol=1e-4)


@pytest.mark.parametrize(("change", "named"), BAD_CASES, ids=str)
def test_invalid_cases_are_refused(change, named):
    with pytest.raises(ValueError, match=named):
        run_case(line_of(), CASE._replace(**change), ALL)


PLAIN = Case(0.1, 1.0, (1.2, 0.5), (np.array([1]),), "exponential")


@pytest.mark.parametrize(
    "changed", [{"speed": -1.0}, {"ratios": (-1.2,)}, {"spectrum": Spectrum((1.0,), (1.0,), 0.0)}]
)
def test_only_kelvin_elements_that_slide_forwards_are_plain(changed):
    assert PLAIN.plain
    assert not PLAIN._replace(**changed).plain
