"""What a quantity asks of a scene, and why it is not there. Refusals: tests/refusals.md."""

import pytest

from elastomer_friction.workflow.study.effects.material import Material
from elastomer_friction.workflow.study.effects.needs import why_not
from elastomer_friction.workflow.study.effects.programme import (
    HoldSegment,
    Oscillate,
    SlideSegment,
    Velocity,
)
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from elastomer_friction.workflow.study.effects.scene import Scene

KELVIN, GLASSY = Material(1e6, 1e-3), Material(1e6, 0.0, ((5e6, 1e-2),))
SLOW, FAST = SlideSegment(Velocity(0.1), 1e-3), SlideSegment(Velocity(0.2), 1e-3)
EVERYTHING = (SLOW, FAST, HoldSegment((1.0,)), SLOW, Oscillate(Velocity(0.1), 1e-4, 10.0, 3))


@pytest.mark.parametrize("name", QUANTITIES)
def test_a_full_programme_of_one_line_can_be_asked_for_everything(name):
    assert why_not(name, Scene(programme=EVERYTHING), {"": KELVIN}, alone=True) == ""


def reasons(scene, material=KELVIN, alone=False):
    return {name for name in QUANTITIES if why_not(name, scene, {"": material}, alone)}


def test_the_scene_of_the_paper_has_no_programme():
    of_programmes = {"trace", "loop", "healing", "energy", "contact_lengths"}
    assert reasons(Scene()) == of_programmes | {"snapshots", "state"}


def test_without_a_dashpot_nothing_jumps():
    assert reasons(Scene(programme=EVERYTHING), GLASSY, alone=True) == {"jump"}


def test_what_is_defined_at_a_normal_force():
    scene = Scene(programme=EVERYTHING, control="indentation")
    left = set(QUANTITIES) - reasons(scene, alone=True)
    assert left == {"models", "trace", "loop", "energy", "contact_lengths", "snapshots", "state"}


def test_a_repeated_list_meets_itself():
    once, twice = (Scene(programme=(SLOW, HoldSegment((1.0,))), repeat=n) for n in (1, 2))
    assert "healing" in reasons(once)
    assert "healing" not in reasons(twice)
