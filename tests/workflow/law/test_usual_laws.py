"""Rate-and-state friction and LuGre agree with closed forms; properties of all laws."""

import numpy as np
import pytest

from elastomer_friction.workflow.law import LuGreLaw, RateStateLaw, read
from elastomer_friction.workflow.law.fitted_law import Validity
from elastomer_friction.workflow.reduce import step_law
from tests.workflow.law.given import memory_law

A, B, LENGTH, V = 0.01, 0.015, 1e-5, 1e-3
LUGRE = LuGreLaw(stiffness=2e4, damping=0.01, viscous=0.4, coulomb=0.5, static=0.7, stribeck=0.01)


def rate_state(ageing):
    validity = Validity(slowest=1e-5, fastest=1.0)
    return RateStateLaw(A, B, LENGTH, 0.6, V, ageing, validity=validity)


LAWS = [rate_state(False), rate_state(True), LUGRE]


@pytest.mark.parametrize(("ageing", "name"), [(False, "ruina"), (True, "dieterich")])
@pytest.mark.parametrize("ratio", [0.1, 3.0])
def test_a_step_is_that_of_the_published_law(ageing, name, ratio):
    law = rate_state(ageing)
    state, _ = law.step(law.init(V), ratio * V, 0.0)
    distances = LENGTH * np.geomspace(1e-3, 5.0, 9)
    mu = [law.step(state, ratio * V, s / (ratio * V))[1] for s in distances]
    expected, _ = step_law(name, ratio)(np.array([[B, np.log(1.0 / LENGTH)]]), distances)
    assert np.array(mu) - law.steady(ratio * V) == pytest.approx(expected[0], rel=1e-6)
    assert law.steady(ratio * V) == pytest.approx(0.6 + (A - B) * np.log(ratio), rel=1e-6)


def test_contacts_age_at_rest_by_dieterichs_law_alone():
    for law in LAWS[:2]:
        state, _ = law.step(law.init(V), 0.0, 0.0)
        state, at_rest = law.step(state, 0.0, 2.0)
        _, mu = law.step(state, V, 0.0)
        healing = B * np.log1p(V * 2.0 / LENGTH) if law.ageing else 0.0
        assert mu - 0.6 == pytest.approx(healing, abs=1e-6)
        assert at_rest == 0.0


def test_lugre_starts_as_a_spring_and_ends_on_its_curve():
    state = LUGRE.init(0.0)
    _, mu = LUGRE.step(state, 1e-9, 1.0)
    assert mu == pytest.approx(LUGRE.stiffness * 0.5e-9, rel=1e-3)  # v grew from rest
    assert LUGRE.steady(0.01) == pytest.approx(0.5 + 0.2 / np.e + 0.004)
    assert LUGRE.step(LUGRE.init(-0.01), -0.01, 1.0)[1] == pytest.approx(-float(LUGRE.steady(0.01)))


@pytest.mark.parametrize("law", [*LAWS, memory_law()], ids=lambda law: law.kind)
def test_steps_are_exact_odd_and_shift_with_the_times_of_the_material(law):
    state, _ = law.step(law.init(V), 4 * V, 0.0)
    whole, mu = law.step(state, 4 * V, 4e-3)
    for _ in range(8):
        state, parted = law.step(state, 4 * V, 0.5e-3)
    assert parted == pytest.approx(mu, rel=1e-12)
    assert state == pytest.approx(whole, rel=1e-12)
    time = np.linspace(0.0, 0.5, 200)
    velocity = V * (1.0 + 0.9 * np.sin(40.0 * time))
    mu = law.run(time, velocity)
    assert law.run(time, -velocity) == pytest.approx(-mu, rel=1e-12)
    assert law.shifted(5.0).run(5.0 * time, velocity / 5.0) == pytest.approx(mu, rel=1e-9)
    assert read(law.to_json()).to_json() == law.to_json()
    assert ("nothing is clamped" in "\n".join(law.told())) == (law in LAWS)
