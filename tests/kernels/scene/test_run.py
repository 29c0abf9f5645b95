"""Runs of scenes: cut and resumed to the bit, and every recorder by itself."""

import numpy as np
import pytest

from elastomer_friction.kernels.motion.legs import Slide
from elastomer_friction.kernels.scene import ASKED, Saved, run_scene, scene_steps
from tests.kernels.scene.given import EVERY, MATERIALS, PRONY, a_line, a_scene

LINE = a_line()
M = LINE.steps_per_spacing
ALL = {"asked": ASKED, "edges": np.array([0.0, 1.0, 2.0, 4.0, 100.0])}


def saved(found):
    """Return the state in which a scene has ended."""
    values = [found[f"state_{name}"] for name in Saved._fields]
    return Saved(*values[:2], *(float(value) for value in values[2:]))


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("cut", [1, 3, 5])
def test_a_programme_cut_and_resumed_is_the_same_to_the_bit(name, cut):
    whole = a_scene(EVERY, MATERIALS[name], M, **ALL)
    one = a_scene(EVERY[:cut], MATERIALS[name], M, **ALL)
    first = run_scene(LINE, one)
    two = whole._replace(programme=EVERY[cut:])
    two = two._replace(kept=np.arange(1, scene_steps(two, M, saved(first).origin).dt.size + 1))
    second, found = run_scene(LINE, two, saved(first)), run_scene(LINE, whole)
    for key in ("mu", "indentation", "normal_force", "friction_force", "contact_fraction"):
        joined = np.append(first[f"trace_{key}"], second[f"trace_{key}"])
        np.testing.assert_array_equal(joined, found[f"trace_{key}"])
    for key in Saved._fields:
        np.testing.assert_array_equal(second[f"state_{key}"], found[f"state_{key}"])
    np.testing.assert_array_equal(
        np.append(first["stored_energy"], second["stored_energy"]), found["stored_energy"]
    )


def test_what_else_is_asked_for_changes_no_bit():
    alone = run_scene(LINE, a_scene(EVERY, PRONY, M))
    together = run_scene(LINE, a_scene(EVERY, PRONY, M, **ALL))
    for name, values in alone.items():
        np.testing.assert_array_equal(together[name], values)
    assert set(alone) == {name for name in together if name.startswith("trace_")} | {"updates"}


def test_lengths_and_fractions_of_contact_agree():
    scene = a_scene(EVERY, PRONY, M, asked=ASKED)
    samples = np.arange(LINE.z.size + 2) - 0.5
    found = run_scene(LINE, scene._replace(edges=samples / M))
    covered = np.sum(found["contact_length"] * np.arange(LINE.z.size + 1)) / LINE.z.size
    assert covered == pytest.approx(found["trace_contact_fraction"].mean(), rel=1e-12)


@pytest.mark.parametrize("start", ["steady", "relaxed"])
def test_snapshots_show_the_line_pressed_into_the_elements(start):
    scene = a_scene((Slide(0.5, 3.1),), PRONY, M, start=start, asked=ASKED)
    frames = np.array([0, 1, 5, scene.kept[-1]])
    found = run_scene(LINE, scene._replace(frames=frames))
    height, u = found["snapshot_height"], found["snapshot_displacement"]
    assert height.shape == u.shape == (4, LINE.z.size)
    gap = height - u
    assert gap.min() > -1e-12
    touching = np.mean(gap < 1e-12, axis=1)
    np.testing.assert_allclose(touching, found["trace_contact_fraction"][frames])
    for frame, step in ((0, 0), (1, 1), (2, 5)):  # whole samples: the line itself, less d
        np.testing.assert_allclose(np.ptp(np.roll(LINE.z, step) - height[frame]), 0.0, atol=1e-12)


def test_work_is_counted():
    short, long = (
        float(run_scene(LINE, a_scene((Slide(0.5, x),), PRONY, M))["updates"]) for x in (2.0, 4.0)
    )
    assert 2 * LINE.z.size * 2.0 * M < short < long
