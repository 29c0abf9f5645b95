"""Fits of laws to motions: known laws are recovered, and held-out motions are within the error."""

import json
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

import elastomer_friction as ef
from elastomer_friction.workflow.law import LoadLaw, LuGreLaw, RateStateLaw, read, transients_of
from elastomer_friction.workflow.law.fitted_law import Validity
from elastomer_friction.workflow.law.memory_names import origins
from elastomer_friction.workflow.law.memory_search import MemorySearch
from elastomer_friction.workflow.law.reduced_law import BeyondLawWarning
from tests.workflow.law.given import SEGMENTS, dataset, memory_law, result

TIME = np.linspace(0.0, 0.3, 1501)
SWING = 0.04 * (1.0 + 0.6 * np.sin(60.0 * np.pi * TIME)) * np.where(TIME > 0.2, -1.0, 1.0)


@pytest.fixture(scope="module")
def known():
    return memory_law(1)


@pytest.fixture(scope="module")
def fitted(known):
    return ef.law.fit(result(known), states=1)


def test_a_law_of_known_numbers_is_recovered(known, fitted):
    assert fitted.rate_per_length == pytest.approx(known.rate_per_length, rel=0.1)
    assert fitted.rate == pytest.approx(known.rate, rel=0.15)
    speeds = np.array([0.01, 0.02, 0.05, 0.1])
    assert fitted.steady(speeds) == pytest.approx(known.steady(speeds), rel=0.01)
    assert fitted.validity.rms < 0.01 * fitted.validity.usual
    assert fitted.validity.held_rms < 0.03 * fitted.validity.usual


def test_a_law_holds_its_range_and_errors(fitted):
    validity = fitted.validity
    assert (validity.slowest, validity.fastest) == (pytest.approx(0.01), pytest.approx(0.1))
    assert validity.longest_rest == pytest.approx(0.4)
    assert validity.normal_force == 2.0
    assert len(validity.motions) == len(SEGMENTS)
    assert validity.rms <= validity.held_rms <= validity.held_largest
    text = "\n".join(fitted.told())
    assert f"{40 * len(SEGMENTS)} samples of {len(SEGMENTS)} segments, all of them" in text
    assert "range: speeds of 0.01 ... 0.1 m/s, rest of 0.4 s at most, normal force 2 N" in text
    assert validity.shortest_stroke == pytest.approx(0.003, rel=1e-3)  # of one segment
    assert "the tables clamp the speed to 0.1 m/s" in text


@pytest.mark.parametrize(
    ("temperature", "expected", "evidence"),
    [
        (None, ("age", "contact"), ""),
        (lambda data: 20.0 + 9.0 * data.age, ("temperature", "contact"), "100 %, "),
        (lambda data: 20.0 + 300.0 * abs(data.trace_velocity), ("age", "contact"), "the velocity"),
        (lambda data: 20.0 + np.sin(9.0 * data.trace_time), ("age", "contact"), "none follows"),
    ],
)
def test_a_memory_is_named_after_the_temperature_that_it_explains(
    known, fitted, temperature, expected, evidence
):
    data = result(known)
    if temperature:
        data["trace_contact_temperature"] = temperature(data)
    motions = transients_of(data)
    names, told = origins(motions, MemorySearch(motions, fitted.speed, 1).responses(fitted))
    assert tuple(names) == expected
    assert evidence in told
    assert bool(told) == bool(evidence)


def test_a_heated_law_keeps_its_names_and_older_laws_have_none(known):
    data = result(known)
    data["trace_contact_temperature"] = 20.0 + 9.0 * data.age
    law = ef.law.fit(data, states=1)
    assert law.names == read(law.to_json()).names == ("temperature", "contact")
    assert "memories: temperature (g, a factor of mu): length 0.000" in "\n".join(law.told())
    for form in ("c", "fortran"):
        text = ef.law.export(law, form, "rubber").content.decode().lower()
        assert "_temperature" in text
        assert "contact (z_1): length" in text
    older = json.loads(law.to_json())
    del older["names"], older["validity"]["memories"]
    assert read(json.dumps(older)).names == ("state_1", "state_2")


def test_a_law_states_the_body_and_the_error_of_the_model(known):
    source = {"body": "half-space", "body_reason": "a map", "model_ratio_source": "unknown: none"}
    stated = ef.law.fit(result(known, **source), states=1)
    line = "Body: half-space, a map. Error of the model: unknown: none"
    assert line in stated.told()
    assert read(stated.to_json()).validity.body == line


def test_the_model_is_compared_with_the_law(known, fitted):
    mu = known.run(TIME, SWING)
    distance = np.concatenate([[0.0], np.cumsum(0.5 * (SWING[1:] + SWING[:-1]) * np.diff(TIME))])
    model = dataset(TIME, SWING, distance, mu, np.where(TIME > 0.2, 1, 0))
    first, second = fitted.compare(model)
    assert first.mu.tolist() == mu[TIME <= 0.2].tolist()
    for segment in (first, second):
        assert segment.rms == pytest.approx(np.sqrt(np.mean((segment.law - segment.mu) ** 2)))
        assert segment.rms < 0.03 * fitted.validity.usual  # tables of other speeds
    other = ef.law.fit([result(known)], states=1, held_out=model)
    assert other.validity.held_out == "synthetic"
    assert other.validity.held_rms == pytest.approx(
        np.sqrt(np.mean(np.concatenate([first.law - first.mu, second.law - second.mu]) ** 2))
    )


@pytest.mark.parametrize("ageing", [False, True])
def test_rate_and_state_is_recovered_with_its_state(ageing):
    law = RateStateLaw(0.01, 0.015, 2e-4, 0.6, 0.03, ageing, validity=Validity(0.01, 0.1))
    slides = [(v, d) for v, d in SEGMENTS if v > 0.0]
    fit = ef.law.fit(result(law, slides), kind="rate-state")
    assert fit.ageing is ageing
    assert (fit.a, fit.b, fit.length) == pytest.approx((0.01, 0.015, 2e-4), rel=1e-3)
    assert fit.validity.held_largest < 1e-5


def test_lugre_is_recovered():
    law = LuGreLaw(3e3, 0.02, 0.5, 0.5, 0.8, 0.03)
    fit = ef.law.fit(result(law), kind="lugre")
    names = ("stiffness", "damping", "viscous", "coulomb", "static", "stribeck")
    assert [getattr(fit, name) for name in names] == pytest.approx(
        [getattr(law, name) for name in names], rel=1e-2
    )


def test_friction_that_follows_the_velocity_at_once_has_no_state():
    viscous = LuGreLaw(1e9, 0.0, 2.0, 1e-6, 1e-6, 0.03)
    fit = ef.law.fit(result(viscous))
    assert len(fit.target) == 0
    assert fit.validity.left < 1e-4
    assert fit.steady(0.05) == pytest.approx(0.1, rel=1e-3)
    over_loads = ef.law.fit([result(viscous, force=force) for force in (1.0, 2.0, 4.0)])
    assert over_loads.target.size == 0


def test_of_several_loads_the_law_is_a_table_over_them(known):
    """Direct effect and states are linear in ln F_N, so that a held-out load is predicted."""
    loads = [1.0, 2.0, 4.0]
    laws = [replace(known, target=f * known.target, direct=f * known.direct) for f in (0.8, 1, 1.2)]
    results = [result(law, force=force) for law, force in zip(laws, loads, strict=True)]
    fit = ef.law.fit([results[k] for k in (2, 0, 1)], states=1)
    assert isinstance(fit, LoadLaw)
    assert fit.load.tolist() == loads
    speeds = np.array([0.01, 0.02, 0.05, 0.1])
    for force, factor in ((1.0, 0.8), (np.sqrt(2.0), 0.9), (4.0, 1.2)):
        steady = fit.at(normal_force=force).steady(speeds)
        assert steady == pytest.approx(factor * known.steady(speeds), rel=0.01)
    usual = fit.validity.usual
    assert fit.validity.rms < 0.01 * usual
    assert fit.validity.held_rms < 0.03 * usual
    assert "; 2 N by the laws of 1 and 4 N, " in fit.validity.held_out
    off = ef.law.fit([results[0], result(laws[2], force=2.0), results[2]], states=1).validity
    assert off.held_rms > 0.15 * usual  # a load that the table does not predict
    text = "\n".join(fit.told())
    assert "rest of 0.4 s at most, normal force 1 ... 4 N" in text
    assert "a load beyond the table is clamped to its end" in text
    with pytest.warns(
        BeyondLawWarning, match=r"outside the fitted 1 ... 4 N; using the nearest load, 4 N"
    ):
        assert fit.at(normal_force=9.0).validity.normal_force == 4.0
    with pytest.raises(
        ef.UserError, match=r"normal_force: missing; must be given for a law over 1 ..."
    ):
        fit.at()
    assert read(fit.to_json()).to_json() == fit.to_json()


def still(velocity, count=40):
    t = np.linspace(0.0, 1.0, count)
    return dataset(t, velocity + 0.0 * t, velocity * t, 0.1 + 0.0 * t, 0 * t.astype(int))


@pytest.mark.parametrize(
    ("results", "options", "message"),
    [
        (still(0.1), {}, "there is nothing to fit: the velocity never changes"),
        (still(0.0), {}, "there is nothing to fit: every motion is at rest"),
        (still(0.1, 5), {}, "there is nothing to fit: the motions hold 5 samples"),
        (still(0.1, 1), {}, "synthetic: its trace holds 1 samples; a law needs two"),
        ([], {}, "there is nothing to fit: no result is given"),
        (still(0.1).assign(resolution_status=0), {}, "its contacts are not resolved"),
        (xr.Dataset(), {}, 'compute it with the quantity "trace"'),
        ("a name", {}, "'a name': must be a dataset"),
        (still(0.1), {"kind": "magic"}, "kind = 'magic': must be one of states, rate-state, lugre"),
        (still(0.1), {"states": 9}, "states = 9: must be a whole number, 0 to 5"),
        (still(0.1), {"point": {"hurst": 0.7}}, "hurst = 0.7: the result has no such point"),
        (
            [result(memory_law()), result(memory_law(), force=3.0)],
            {},
            r"normal_force of \[2.0, 3.0\]: a law over the load requires .* 3 loads or more",
        ),
    ],
)
def test_results_that_cannot_be_fitted_are_refused(results, options, message):
    with pytest.raises(ef.UserError, match=message):
        ef.law.fit(results, **options)


def test_traces_too_coarse_to_know_the_motion_are_refused():
    t = np.arange(40) / 30.0
    with pytest.raises(
        ef.UserError, match=r"miss .* % of the distance: its samples are too coarse"
    ):
        ef.law.fit(dataset(t, 0.1 + 0.0 * t, 0.05 * t, 0.0 * t, 0 * t.astype(int)))


def test_points_of_a_grid_are_chosen_and_holds_are_motions(known):
    one, other = result(known), result(known, SEGMENTS[:8])
    grid = xr.concat([one, one.assign(trace_mu=2.0 * one.trace_mu)], "hurst")
    grid = grid.assign_coords(hurst=[0.3, 0.7])
    with pytest.raises(
        ef.UserError, match=r"several points; choose one by point: hurst of \[0.3, 0.7\]"
    ):
        ef.law.fit(grid)
    (twice,) = ef.law.transients_of(grid, {"hurst": 0.69})
    known = np.isfinite(twice.mu)
    assert twice.mu[known].tolist() == (2.0 * one.trace_mu.values).tolist()
    names = ["trace_time", "trace_velocity", "trace_distance", "trace_mu"]
    less = (0, one.sizes["event"] - other.sizes["event"])
    segment = other.trace_segment.pad(event=less, constant_values=-1)
    other = other.pad(event=less)[names].assign(trace_segment=segment)
    holds = xr.concat([one, other], "hold").assign_coords(hold=[1.0, 5.0])
    first, second = ef.law.transients_of(holds)
    assert [first.name, second.name] == ["synthetic, hold 1", "synthetic, hold 5"]
    assert np.isfinite(second.mu).sum() == 8 * 40


def test_a_jump_between_samples_is_where_both_positions_meet(known):
    (motion,) = ef.law.transients_of(result(known))
    jumps = np.flatnonzero((np.diff(motion.time) == 0.0) & (np.diff(motion.velocity) != 0.0))
    ends = np.cumsum([duration for _, duration in SEGMENTS])[:-1]
    assert motion.time[jumps] == pytest.approx(ends, abs=1e-9)


RUBBER = {"shear_modulus": 1e7, "branches": [[7e6, 10.0**k] for k in (-4.0, -3.0, -2.0, -1.0)]}
SURFACE = {"length": 0.01, "hurst": 0.7, "roughness": 1e-5, "spacing": 1e-4}


def model(programme, **more):
    usual = {"material": RUBBER, "realizations": 4, "numerics": {"samples": 1500, "record": "log"}}
    return ef.scene.run(
        surface=SURFACE, normal_force=0.4, programme=programme, seed=3, **{**usual, **more}
    )


def test_a_law_is_shifted_to_another_temperature_by_the_shift_of_its_times():
    """WLF gives log10 a_T = -8 (T - T_ref)/(60 K + T - T_ref): 1/464 of the times at +30 K."""
    a = 10.0 ** (-8.0 * 30.0 / 90.0)
    laws = []
    for temperature, factor in ((20.0, 1.0), (50.0, a)):
        shift = {"temperature": temperature, "wlf": {"c1": 8.0, "c2": 60.0, "reference": 20.0}}
        speeds = 0.024 / factor * np.array([0.2, 1.0, 0.5, 0.2, 1.0])
        legs = [{"slide": {"velocity": float(v), "distance": 1e-3}} for v in speeds]
        numerics = {"samples": 200, "record": "log"}
        fit = model(legs, material={**RUBBER, **shift}, numerics=numerics, realizations=1)
        laws.append(ef.law.fit(fit, states=1))
    shifted, other = laws[0].at(temperature=50.0), laws[1]
    assert shifted.to_json() == read(laws[0].to_json()).at(temperature=50.0).to_json()
    assert shifted.speed == pytest.approx(laws[0].shifted(a).speed, rel=1e-12)
    with pytest.raises(ef.UserError, match=r"temperature = -50\.0: must be above reference - c2"):
        shifted.at(temperature=-50.0)
    assert shifted.validity.fastest == pytest.approx(other.validity.fastest)
    v = np.geomspace(other.validity.slowest, other.validity.fastest, 9)
    assert shifted.steady(v) == pytest.approx(other.steady(v), rel=1e-3)
    time = np.linspace(0.0, 0.05 * a, 101)
    swing = 0.012 / a * (1.0 + 0.6 * np.sin(time / time[-1] * 9.0))
    assert shifted.run(time, swing) == pytest.approx(other.run(time, swing), rel=1e-2)


def test_a_motion_of_30_hz_with_rest_and_reversal_is_within_the_stated_error():
    """A small model: steps, reversals and holds are fitted; the held-out v(t) swings by 60 %."""
    v = 0.024
    ratios = [0.1, 0.25, 0.5, 1, 2, 0.5, 1, 0.1, 2, 0.25, 1, -1, 0.5, -0.5, 1]
    ratios += [0, 1, 0, 0.5, 0, 1, 0, 0.5]
    rests = iter([0.05, 0.5, 0.05, 0.5])
    programme = [{"slide": {"velocity": v, "distance": 1e-3}}]
    for ratio in ratios:
        slide = {"slide": {"velocity": ratio * v, "distance": 3e-3}}
        programme.append(slide if ratio else {"hold": {"duration": next(rests)}})
    for ends, duration in (([0.5 * v, -v], 0.1), ([-v, 2 * v], 0.03)):  # slowly through zero
        programme.append({"ramp": {"velocity": ends, "duration": duration}})
        programme.append({"slide": {"velocity": ends[1], "distance": 2e-3}})
    fit = ef.law.fit(model(programme))
    time = np.linspace(0.0, 0.2, 1001)
    swing = 1.0 + 0.6 * np.sin(60.0 * np.pi * time)
    sign = np.interp(time, [0.0, 0.08, 0.1, 0.13, 0.14, 0.2], [1.0, 1.0, 0.0, 0.0, -1.0, -1.0])
    held = model([programme[0], {"time": time, "velocity": v * swing * sign}])
    _, motion = fit.compare(held)
    assert np.ptp(motion.velocity) > 0.07
    assert motion.rms < fit.validity.held_rms
    assert motion.largest < fit.validity.held_largest
    assert fit.validity.held_rms < 0.2 * fit.validity.usual
    with pytest.warns(BeyondLawWarning, match="m between two turns is less than in the fitted"):
        fit.run(time, 1.5 * v * np.sin(60.0 * np.pi * time))
    others = [ef.law.fit(model(programme), kind=kind) for kind in ("rate-state", "lugre")]
    assert all(fit.validity.rms < other.validity.rms for other in others)
