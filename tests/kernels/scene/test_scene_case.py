"""Scenes: their steps and time stamps, and what is refused."""

import math
import re

import numpy as np
import pytest

from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Slide, steps_of
from elastomer_friction.kernels.rheology.forms import FORMS
from elastomer_friction.kernels.rheology.law import law_of
from elastomer_friction.kernels.scene import run_scene, scene_steps, trace_stamps
from elastomer_friction.kernels.scene.scene_case import indentation_at
from tests.kernels.scene.given import DAMPED, EVERY, SOLID, a_line, a_scene

M = 4


@pytest.mark.parametrize("scheme", FORMS)
def test_stamps_are_where_and_when_the_force_of_a_step_acts(scheme):
    scene = a_scene(EVERY, DAMPED, M, scheme=scheme)
    steps, stamps = steps_of(EVERY, M), trace_stamps(scene, M)
    lag = np.array([law_of(FORMS[scheme](DAMPED), dt).lag for dt in steps.dt])
    place = np.append(0.0, steps.position) / M
    np.testing.assert_allclose(stamps["time"][1:], np.cumsum(steps.dt) - lag * steps.dt)
    acting = (1.0 - lag) * place[1:] + lag * place[:-1]
    np.testing.assert_allclose(stamps["distance"][1:], acting, atol=1e-12)
    np.testing.assert_allclose(stamps["speed"][1:], np.diff(place) / steps.dt, atol=1e-12)
    np.testing.assert_array_equal(stamps["leg"][1:], steps.leg)
    assert [stamps[name][0] for name in ("time", "distance", "speed", "leg")] == [0, 0, 0.5, 0]


def test_some_kept_steps_have_the_stamps_of_all():
    every = a_scene(EVERY, SOLID, M)
    some = every._replace(kept=np.array([0, 3, 17, 40]))
    for name, values in trace_stamps(every, M).items():
        np.testing.assert_array_equal(trace_stamps(some, M)[name], values[some.kept])


def test_steps_at_rest_end_where_the_indentation_history_has_its_times():
    times = (0.0, 0.3, 2.7, 9.0)
    scene = a_scene((Slide(1.0, 1.0), Hold(5.0)), SOLID, M, indentation=(times, (1.0,) * 4))
    steps, plain = scene_steps(scene, M), steps_of(scene.programme, M)
    end = np.cumsum(steps.dt)
    assert np.abs(end - 2.7).min() < 1e-12
    assert end.size == plain.dt.size + 1  # 0.3 lies within the slide, 9 beyond the end
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
    ({"asked": ("heat",)}, "asked = ['heat']: use some of"),
    ({"asked": ("energy",), "scheme": "implicit-euler"}, "energy is that of the scheme"),
    ({"asked": ("contact_lengths",), "edges": np.array([2.0, 1.0])}, "edges must increase"),
    ({"kept": np.array([0, 5])}, "kept must hold increasing numbers of steps, 0 to 4"),
    ({"kept": np.array([2, 1])}, "kept must hold increasing numbers of steps"),
    ({"frames": np.array([-1])}, "frames must hold increasing numbers of steps"),
    ({"load": 0.0}, "load = 0: must lie between"),
    ({"load": math.nan}, "load = nan: must lie between"),
    ({"load": 1.0, "indentation": 1.0}, "load and indentation are both given"),
    ({"programme": (Hold(1.0),)}, "first speed = 0: must lie between"),
    ({"programme": (Oscillation(0.0, 1.0, 1.0, 1),)}, "first speed = 0: must lie between"),
    ({"spectrum": DAMPED, "start": "fresh"}, 'start = "fresh": a dashpot carries any load'),
]


@pytest.mark.parametrize(("changes", "message"), REFUSED, ids=[text for _, text in REFUSED])
def test_scenes_without_meaning_are_refused(changes, message):
    scene = a_scene(**{"programme": SLIDE, "m": M} | changes)
    with pytest.raises(ValueError, match=re.escape(message)):
        run_scene(a_line(10), scene)


@pytest.mark.parametrize("programme", [(), (Hold(0.0),)])
def test_a_programme_without_a_step_is_refused(programme):
    with pytest.raises(ValueError, match="programme: its legs take no time"):
        a_scene(programme, m=M)
