"""The law with exponential states: closed forms, symmetries, an independent integration."""

import json
import warnings

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from elastomer_friction.workflow.given_motion import distances_between_turns
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.law import MemoryLaw, read
from elastomer_friction.workflow.law.fitted_law import Validity
from elastomer_friction.workflow.law.reduced_law import BeyondLawWarning
from tests.workflow.law.given import SPEEDS, memory_law

LAW = memory_law()
STATE = LAW.init(0.02)
TIME = np.linspace(0.0, 0.3, 3001)
SWING = 0.04 * (1.0 + 0.6 * np.sin(60.0 * np.pi * TIME)) * np.where(TIME > 0.2, -1.0, 1.0)


@pytest.mark.parametrize("v", [-0.3, -0.03, 0.0, 1e-4, 0.07])
def test_steady_sliding_persists_and_equals_the_table(v):
    state = LAW.init(v)
    for dt in (0.0, 1e-4, 10.0):
        state, mu = LAW.step(state, v, dt)
        assert mu == pytest.approx(float(LAW.steady(v)), rel=1e-13, abs=1e-15)


def test_steady_friction_is_odd_linear_in_region_one_and_constant_above():
    v = np.array([-0.2, -0.03, 0.02, 0.5])
    assert LAW.steady(-v).tolist() == (-LAW.steady(v)).tolist()
    slope = LAW.steady(SPEEDS[0]) / SPEEDS[0]
    assert LAW.steady(SPEEDS[0] * np.array([0.0, 0.1, 0.7])) == pytest.approx(
        slope * SPEEDS[0] * np.array([0.0, 0.1, 0.7]), rel=1e-13
    )
    assert LAW.steady(0.5) == LAW.steady(SPEEDS[-1])


def test_an_independent_integrator_agrees():
    """solve_ivp integrates the differential equations for a smooth v(t) through zero."""

    def velocity(t):
        return 0.05 * np.cos(40.0 * t)

    def table(v, values):
        at = np.interp(abs(v), [0.0, *SPEEDS], [0.0, *values])
        return np.sign(v) * at

    def change(t, y):
        v = velocity(t)
        target = [np.interp(abs(v), SPEEDS, LAW.age), *(table(v, row) for row in LAW.target)]
        return (abs(v) * LAW.rate_per_length + LAW.rate) * (np.array(target) - y)

    time = np.linspace(0.0, 0.2, 2001)
    states = solve_ivp(
        change, (0.0, 0.2), LAW.init(0.05)[1:], t_eval=time, rtol=1e-9, atol=1e-11, max_step=1e-4
    ).y
    direct = np.array([table(velocity(t), LAW.direct) for t in time])
    expected = states[0] * (direct + states[1:].sum(axis=0))
    errors = [np.abs(LAW.run(time[::n], velocity(time[::n])) - expected[::n]).max() for n in (1, 4)]
    assert errors[0] < 2e-4 * np.abs(expected).max()
    assert errors[1] < 10.0 * errors[0]  # of fourfold samples: v(t) is linear between them


def test_a_factor_of_times_must_be_positive():
    with pytest.raises(UserError, match=r"factor = 0.0: must be greater than zero"):
        LAW.shifted(0.0)


def test_a_law_warns_above_its_range():
    law = LAW.with_validity(Validity(slowest=0.01, fastest=0.1))
    with pytest.warns(
        BeyondLawWarning, match=r"0.2 m/s is above the fastest fitted speed, 0.1 m/s"
    ):
        law.run([0.0, 1.0], [0.2, 0.2])


def test_a_law_warns_of_turns_closer_than_those_of_its_motions():
    """Between the turns of v0 cos(w t) a motion slides by 2 v0/w; a rest between is no distance."""
    law = LAW.with_validity(Validity(slowest=0.01, fastest=0.1, shortest_stroke=2e-3))
    time, v0 = np.linspace(0.0, 1.0, 4001), 0.05
    for stroke, warns in ((1.9e-3, True), (2.1e-3, False)):
        velocity = v0 * np.cos(2.0 * v0 / stroke * time)
        assert distances_between_turns(time, velocity) == pytest.approx(stroke, rel=1e-3)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            law.run(time, velocity)
        assert [item.category for item in caught] == [BeyondLawWarning] * warns
    jumps = [0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]
    given = np.array(jumps), np.array([1.0, 1.0, -2.0, -2.0, 0.0, 0.0, 3.0, 3.0])
    assert distances_between_turns(*given).tolist() == [2.0]


def test_json_keeps_every_bit(tmp_path):
    law = LAW.with_validity(Validity(fastest=0.1, motions=(("one", 1 / 3),), held_out="nothing"))
    path = tmp_path / "law.json"
    path.write_text(law.to_json())
    assert read(str(path)).to_json() == law.to_json()
    again = read(path)
    assert isinstance(again, MemoryLaw)
    assert again.to_json() == law.to_json()
    assert again.run(TIME, SWING).tolist() == LAW.run(TIME, SWING).tolist()
    assert read(memory_law(0).to_json()).steady(0.02) == memory_law(0).steady(0.02)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"kind": "magic"}, "is not a law as JSON: 'magic'"),
        ({"age": [np.inf] * 5}, "age = .*: must be finite"),
        ({"age": [10**400] * 5}, "int too large"),
        ({"age": "x"}, "age = 'x': must be finite"),
        ({"validity": {**json.loads(LAW.to_json())["validity"], "body": 3}}, "validity.body = 3: "),
        ({"names": ["age", "a/b", "contact"]}, "must be 3 different names of memories"),
        ({"format": 2}, "its format is 2, not 1"),
        ({"speed": [0.01]}, "two speeds or more, and one value per speed"),
        ({"speed": [0.02, 0.01, 0.03, 0.04, 0.05]}, "speed must be positive and increasing"),
        ({"rate": [-1.0, 1.0, 1.0]}, "rates must not be negative"),
    ],
)
def test_invalid_json_is_refused(change, message):
    with pytest.raises(UserError, match=message):
        read(json.dumps({**json.loads(LAW.to_json()), **change}))
    with pytest.raises(UserError, match="is not a law as JSON"):
        read("[")


@pytest.mark.parametrize(
    ("call", "arguments", "message"),
    [
        (LAW.run, ([0.0, 1.0], [0.1]), "one value per time"),
        (LAW.run, ([1.0, 0.0], [0.1, 0.1]), "time must increase"),
        (LAW.run, ([0.0, 1.0], [0.1, np.nan]), "velocity must be finite"),
        (LAW.run, ([0.0, 1.0], np.ma.masked_greater([0.1, 9.0], 1.0)), "velocity must hold real"),
        (LAW.run, (["a"], [0.1]), "must hold real numbers"),
        (LAW.step, (STATE, 0.02, -1.0), "dt = -1.0: must not be negative"),
        (LAW.step, (STATE, 0.02, np.nan), "dt = nan: must be a finite number, in s"),
        (LAW.step, (STATE, np.inf, 0.1), "v = inf: must be a finite number, in m/s"),
        (LAW.step, (STATE, "fast", 0.1), "v = 'fast': must be a finite number, in m/s"),
        (LAW.step, (STATE[:2], 0.02, 0.1), "must be 4 finite numbers, as init returns"),
        (LAW.step, (np.nan * STATE, 0.02, 0.1), "must be 4 finite numbers, as init returns"),
        (LAW.init, (np.nan,), "velocity = nan: must be a finite number, in m/s"),
        (LAW.steady, (np.nan,), "v must be finite"),
    ],
)
def test_invalid_motions_and_steps_are_refused(call, arguments, message):
    with pytest.raises(UserError, match=message):
        call(*arguments)


def test_an_empty_motion_gives_no_friction():
    assert LAW.run([], []).shape == (0,)
