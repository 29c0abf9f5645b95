"""Scenes: initial states, steps and recorded values."""

import itertools
import math
import re

import numpy as np
import pytest

from elastomer_friction.kernels.body.force_means import forces_at_start
from elastomer_friction.kernels.body.patch_width import samples_per_contact
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Slide, steps_of
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import law_of, predict
from elastomer_friction.kernels.scene import (
    MOTION_TRACES,
    SCENE_QUANTITIES,
    run_scene,
    scene_steps,
)
from elastomer_friction.kernels.scene.initial_state import fresh_elements, relaxed_elements
from elastomer_friction.kernels.scene.records import (
    ContactLengths,
    Trace,
    count_lengths,
    record_trace,
)
from elastomer_friction.kernels.scene.scene_case import indentation_at
from tests.kernels.scene.given import (
    ANY_MOTION,
    DAMPED,
    EVERY_LEG,
    MATERIALS,
    PRONY,
    SOLID,
    a_line,
    a_scene,
)

M = 4


@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_a_trace_has_the_place_and_time_at_which_the_force_of_a_step_acts(scheme):
    result = run_scene(a_line(), a_scene(EVERY_LEG, DAMPED, M, scheme=scheme))
    time, distance, velocity = (result[name] for name in MOTION_TRACES)
    steps = steps_of(EVERY_LEG, M)
    lag = np.array([law_of(FORMS_BY_SCHEME[scheme](DAMPED), dt).lag for dt in steps.dt])
    place = np.append(0.0, steps.position) / M
    np.testing.assert_allclose(time[1:], np.cumsum(steps.dt) - lag * steps.dt)
    acting = (1.0 - lag) * place[1:] + lag * place[:-1]
    np.testing.assert_allclose(distance[1:], acting, atol=1e-12)
    np.testing.assert_allclose(velocity[1:], np.diff(place) / steps.dt, atol=1e-12)
    assert (time[0], distance[0], velocity[0]) == (0.0, 0.0, 0.5)


@pytest.mark.parametrize("piece", [1, 7, 50])
def test_a_path_in_stages_gives_the_same_bits(monkeypatch, piece):
    scene = a_scene(EVERY_LEG, DAMPED, M)._replace(requested=SCENE_QUANTITIES)
    whole = run_scene(a_line(), scene)
    monkeypatch.setattr("elastomer_friction.kernels.motion.track.MAX_STAGE_STEPS", piece)
    parts = run_scene(a_line(), scene)
    for name, values in whole.items():
        np.testing.assert_array_equal(parts[name], values, err_msg=name)


def test_recorded_steps_do_not_depend_on_other_recorded_steps():
    every = a_scene(EVERY_LEG, SOLID, M)
    some = every._replace(recorded=np.array([0, 3, 17, 40]))
    whole, part = (run_scene(a_line(), scene) for scene in (every, some))
    for name in MOTION_TRACES:
        np.testing.assert_array_equal(part[name], whole[name][some.recorded])


def test_steps_at_rest_end_at_the_times_of_the_indentation_history():
    times = (0.0, 0.3, 2.7, 9.0)
    scene = a_scene((Slide(1.0, 1.0), Hold(5.0)), SOLID, M, indentation=(times, (1.0,) * 4))
    steps, plain = scene_steps(scene, M), steps_of(scene.programme, M)
    end = np.cumsum(steps.dt)
    assert np.abs(end - 2.7).min() < 1e-12
    assert end.size == plain.dt.size + 1  # 0.3 is during the slide, 9 after the end
    np.testing.assert_allclose(end[[3, -1]], np.cumsum(plain.dt)[[3, -1]], rtol=1e-13)
    np.testing.assert_array_equal(steps.position[:4], plain.position[:4])
    np.testing.assert_array_equal(steps.dt[:4], plain.dt[:4])


def test_the_prescribed_indentation_is_over_the_mean_line():
    scene = a_scene((Hold(1.0),), SOLID, M, indentation=((0.0, 2.0), (1.0, 3.0)), start="relaxed")
    np.testing.assert_allclose(indentation_at(scene, np.array([1.0, 5.0]), -0.5), [2.5, 3.5])
    constant = scene._replace(indentation=1.0)
    np.testing.assert_allclose(indentation_at(constant, np.arange(3.0), -0.5), [1.5] * 3)


SLIDE = (Slide(1.0, 1.0),)
REFUSED = [
    ({"start": "now"}, "start = 'now': use one of"),
    ({"requested": ("heat",)}, "requested = ['heat']: use some of"),
    ({"requested": ("energy",), "scheme": "implicit-euler"}, "energy needs the scheme"),
    ({"requested": ("contact_lengths",), "edges": np.array([2.0, 1.0])}, "edges must increase"),
    ({"recorded": np.array([0, 5])}, "recorded must hold increasing numbers of steps, 0 to 4"),
    ({"recorded": np.array([2, 1])}, "recorded must hold increasing numbers of steps"),
    ({"frames": np.array([-1])}, "frames must hold increasing numbers of steps"),
    ({"load": 0.0}, "load = 0: must lie between"),
    ({"load": math.nan}, "load = nan: must lie between"),
    ({"load": 1.0, "indentation": 1.0}, "load and indentation are both given"),
    ({"programme": (Hold(1.0),)}, "first speed = 0: must lie between"),
    ({"programme": (Oscillation(0.0, 1.0, 1.0, 1),)}, "first speed = 0: must lie between"),
    ({"spectrum": DAMPED, "start": "fresh"}, 'start = "fresh": a dashpot carries any load'),
]


@pytest.mark.parametrize(("changes", "message"), REFUSED, ids=[text for _, text in REFUSED])
def test_invalid_scenes_are_refused(changes, message):
    scene = a_scene(**{"programme": SLIDE, "m": M} | changes)
    with pytest.raises(ValueError, match=re.escape(message)):
        run_scene(a_line(10), scene)


@pytest.mark.parametrize("programme", [(), (Hold(0.0),)])
def test_a_programme_without_a_step_is_refused(programme):
    with pytest.raises(ValueError, match="programme: its legs take no time"):
        a_scene(programme, m=M)


LINE = a_line()
TOTAL = 0.3 * LINE.z.size


@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
@pytest.mark.parametrize("name", MATERIALS)
def test_relaxed_elements_are_in_equilibrium(scheme, name):
    form = FORMS_BY_SCHEME[scheme](MATERIALS[name])
    elements = relaxed_elements(form, LINE.z, TOTAL, np.nan)
    np.testing.assert_allclose(elements.p, np.maximum(0.0, elements.d - LINE.z), atol=1e-12)
    assert elements.p.sum() == pytest.approx(TOTAL, rel=1e-12)
    law, w = law_of(form, 0.3), np.empty(LINE.z.size)
    predict(law, elements.memory, elements.p, w)
    again = law.stiffness * np.maximum(0.0, elements.d - (LINE.z - w))
    np.testing.assert_allclose(again, elements.p, atol=1e-11)


@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
@pytest.mark.parametrize("spectrum", [SOLID, PRONY], ids=["solid", "prony"])
def test_fresh_elements_are_glassy_and_keep_their_force_for_a_moment(scheme, spectrum):
    form = FORMS_BY_SCHEME[scheme](spectrum)
    stiffness = 1.0 + sum(spectrum.moduli)
    elements = fresh_elements(form, spectrum, LINE.z, TOTAL, np.nan)
    np.testing.assert_allclose(
        elements.p, stiffness * np.maximum(0.0, elements.d - LINE.z), rtol=1e-9
    )
    assert elements.p.sum() == pytest.approx(TOTAL, rel=1e-12)
    law, w = law_of(form, 1e-7), np.empty(LINE.z.size)
    predict(law, elements.memory, elements.p, w)
    again = law.stiffness * np.maximum(0.0, elements.d - (LINE.z - w))
    np.testing.assert_allclose(again, elements.p, rtol=1e-3, atol=1e-6)


RNG = np.random.default_rng(4)


def test_a_trace_is_friction_force_and_contact_at_the_moment_the_force_acts():
    now = RNG.normal(size=40)
    p = np.maximum(0.0, RNG.normal(size=40))
    trace = Trace(*np.zeros((9, 3)))
    record_trace(trace, 1, 0.3, forces_at_start(p, now, 0.3), 2.0, 1.0, samples_per_contact(p))
    acting = 0.7 * now + 0.3 * np.roll(now, -1)
    assert trace.mu[1] == pytest.approx(p @ acting / p.sum())
    assert trace.friction_force[1] == pytest.approx(np.mean(p * acting))
    assert trace.normal_force[1] == pytest.approx(p.mean())
    assert trace.contact_fraction[1] == np.mean(p > 0.0)
    assert trace.samples_per_contact[1] == samples_per_contact(p)
    assert trace.indentation[1] == pytest.approx(1.3)
    for values in trace:
        assert values[0] == values[2] == 0.0


def test_friction_is_not_a_number_where_nothing_touches():
    trace = Trace(*np.zeros((9, 1)))
    record_trace(trace, 0, 0.3, forces_at_start(np.zeros(4), np.ones(4), 0.3), 1.0, 1.0, 0.0)
    assert np.isnan(trace.mu[0])
    assert trace.friction_force[0] == trace.normal_force[0] == trace.contact_fraction[0] == 0.0


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_contact_lengths_are_those_of_periodic_runs(share):
    pressed = RNG.random(200) < share
    free = int(np.argmin(pressed))
    turned = np.roll(pressed, -free)
    runs = [len(list(run)) for touching, run in itertools.groupby(turned) if touching]
    for shift in (0, 1, 57):
        lengths = ContactLengths(np.array([1.0, 2.0, 4.0, 8.0, 300.0]), np.zeros(4))
        count_lengths(lengths, np.roll(pressed, shift).astype(float))
        np.testing.assert_array_equal(lengths.counts, np.histogram(runs, lengths.edges)[0])


def test_full_contact_counts_one_contact_and_no_contact_none():
    lengths = ContactLengths(np.array([0.0, 9.5, 20.0]), np.zeros(2))
    count_lengths(lengths, np.ones(10))
    count_lengths(lengths, np.zeros(10))
    np.testing.assert_array_equal(lengths.counts, [0.0, 1.0])


def test_lengths_and_fractions_of_contact_agree():
    scene = a_scene(EVERY_LEG, PRONY, M, requested=SCENE_QUANTITIES)
    samples = np.arange(LINE.z.size + 2) - 0.5
    result = run_scene(LINE, scene._replace(edges=samples / M))
    covered = np.sum(result["contact_length"] * np.arange(LINE.z.size + 1)) / LINE.z.size
    assert covered == pytest.approx(result["trace_contact_fraction"].mean(), rel=1e-12)


@pytest.mark.parametrize("start", ["steady", "relaxed"])
def test_snapshots_show_the_line_pressed_into_the_elements(start):
    scene = a_scene((Slide(0.5, 3.1),), PRONY, M, start=start, requested=ANY_MOTION)
    frames = np.array([0, 1, 5, scene.recorded[-1]])
    result = run_scene(LINE, scene._replace(frames=frames))
    height, u = result["snapshot_height"], result["snapshot_displacement"]
    assert height.shape == u.shape == (4, LINE.z.size)
    gap = height - u
    assert gap.min() > -1e-12
    touching = np.mean(gap < 1e-12, axis=1)
    np.testing.assert_allclose(touching, result["trace_contact_fraction"][frames])
    for frame, step in ((0, 0), (1, 1), (2, 5)):  # whole samples: the given line, less d
        np.testing.assert_allclose(np.ptp(np.roll(LINE.z, step) - height[frame]), 0.0, atol=1e-12)


def test_work_is_counted():
    short, long = (
        float(run_scene(LINE, a_scene((Slide(0.5, x),), PRONY, M))["updates"]) for x in (2.0, 4.0)
    )
    assert 2 * LINE.z.size * 2.0 * M < short < long
