"""Steps behind a spring, integrated in another way: a, b and D_c, their errors, and the limit."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from elastomer_friction.workflow.laboratory.parting import measured_steps
from elastomer_friction.workflow.laboratory.record import Record
from elastomer_friction.workflow.laboratory.sentences import describe
from elastomer_friction.workflow.laboratory.step_fit import NEITHER_TEXT, fit_step
from elastomer_friction.workflow.laboratory.together import Known, fit_records

A, B, LENGTH = 0.01, 0.012, 1e-5  # D_c in m
V1, V2 = 1e-6, 1e-5
NOISE = 2e-4


def behind_spring(law, stiffness, *, a=A, b=B, seed=0, noise=NOISE, step=0.1):
    """Return a record of theta and v themselves, by an implicit method."""
    t = np.arange(-10.0, 30.0, step) + 0.5 * step

    def change(_, y):
        v, theta = y
        phase = v * theta / LENGTH
        ageing = 1.0 - phase if law == "dieterich" else -phase * np.log(phase)
        return [v * (stiffness * (V2 - v) - b * ageing / theta) / a, ageing]

    after = t[t > 0.0]
    found = solve_ivp(
        change, (0.0, t[-1]), [V1, LENGTH / V1], "Radau", after, rtol=1e-9, atol=[1e-15, 1e-9]
    )
    v, theta = found.y
    mu = 0.6 + a * np.log(v / V1) + b * np.log(theta * V1 / LENGTH)
    mu = np.concatenate([np.full(t.size - after.size, 0.6), mu])
    mu += noise * np.random.default_rng(seed).standard_normal(t.size)
    return Record("r", t, np.where(t < 0.0, V1, V2), mu)


@pytest.mark.parametrize(
    ("law", "a", "b", "stiffness"),
    [
        ("dieterich", A, 0.009, 1e3),  # DiaBayes's example
        ("dieterich", A, 0.015, 5e3),
        ("ruina", A, 0.009, 1e3),
        ("ruina", A, 0.015, 5e3),
        ("dieterich", 0.005, 0.01, 1e3),  # rsfmodel's first: underdamped, weakens with velocity
    ],
)
def test_what_is_behind_a_spring_is_recovered(law, a, b, stiffness):
    fit = fit_step(*measured_steps(behind_spring(law, stiffness, a=a, b=b)), law, stiffness)
    for estimate, right in zip(fit.state(), (a, b, LENGTH), strict=True):
        assert abs(estimate.value - right) < 4.0 * estimate.error
        assert estimate.error < 0.02 * right
    assert fit.rms == pytest.approx(NOISE, rel=0.15)


def test_the_rate_is_unbiased_within_its_error():
    right, fits = V2 / LENGTH, []
    for seed in range(4):
        one = behind_spring("ruina", 2e3, seed=seed, step=0.3)
        fits.append(fit_step(*measured_steps(one), "ruina", 2e3).rate)
    off = np.array([(fit.value - right) / fit.error for fit in fits])
    assert abs(off.mean()) < 3.0 / np.sqrt(off.size)
    assert np.sqrt(np.mean(off**2)) < 2.0


def test_the_error_of_another_stiffness_shows_in_the_residual():
    one = behind_spring("dieterich", 1e3)
    rms = [fit_step(*measured_steps(one), "dieterich", k).rms for k in (1e3, 2e3)]
    assert rms[1] > 2.0 * rms[0]


def test_a_stiff_spring_is_none():
    """At k = 1e7 1/m the slider follows in a/(k v2) = 0.1 ms."""
    one = behind_spring("ruina", 1e7)
    stiff, plain = (fit_step(*measured_steps(one), "ruina", k) for k in (1e7, None))
    for name in ("mu_1", "mu_2", "jump", "rate"):
        own, other = getattr(stiff, name), getattr(plain, name)
        assert own.value == pytest.approx(other.value, abs=2.0 * other.error)
    assert stiff.jump.value == pytest.approx(A * np.log(10.0), abs=4.0 * stiff.jump.error)


def test_the_reason_of_a_soft_machine_names_the_option_that_goes_on():
    one = behind_spring("dieterich", 600.0, a=0.02, b=0.015, noise=2e-5)
    assert "give its --stiffness" in NEITHER_TEXT
    assert NEITHER_TEXT in "\n".join(describe(fit_records([one], Known())))
    text = "\n".join(describe(fit_records([one], Known(), stiffness=600.0)))
    assert "spring                  600 1/m, of the machine, is part of the fit" in text
    assert NEITHER_TEXT not in text
