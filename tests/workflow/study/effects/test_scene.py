"""The table [scene]: its defaults, what of the grid it takes, what it can be asked for."""

import math

import pytest

from elastomer_friction.workflow.study.effects.material import Material
from elastomer_friction.workflow.study.effects.programme import (
    HoldSegment,
    Oscillate,
    Scene,
    SlideSegment,
    Spring,
    Velocity,
)
from elastomer_friction.workflow.study.effects.quantities import (
    QUANTITIES,
    accuracy_estimates,
    unavailable_reason,
)
from elastomer_friction.workflow.study.effects.scene import SCENE, read_scene_table
from elastomer_friction.workflow.study.settings import checked
from tests.support.small import small_study

KELVIN = Material(1e6, 1e-3)
GLASSY = Material(1e6, 0.0, ((5e6, 1e-2),))
SLIDE = {"slide": {"velocity": 0.1, "distance": 1e-3}}
FASTER = {"slide": {"ratio": 1.2, "distance": 1e-3}}
HOLD = {"hold": {"duration": 1.0}}


def read(*materials, **table):
    return read_scene_table(checked("scene", table, SCENE), None, materials or (KELVIN,))


def test_without_keys_it_is_the_scene_of_the_paper():
    assert read() == Scene()
    assert Scene().uses_velocity
    assert Scene().start_velocity(0.7) == 0.7


def test_what_is_asked_for_by_default():
    assert read(KELVIN, GLASSY).quantities == ("steady", "relaxation", "peak")
    assert read(programme=[SLIDE]).quantities == ("steady", "trace")
    assert read(programme=[SLIDE], control="indentation").quantities == ("trace",)


def test_velocities_of_the_grid_are_taken_where_a_segment_refers_to_them():
    assert not read(programme=[SLIDE]).uses_velocity
    assert read(programme=[SLIDE, FASTER]).uses_velocity
    assert read(programme=[HOLD, SLIDE]).uses_velocity  # at which it slid before
    assert not read(programme=[HOLD, SLIDE], start="relaxed").uses_velocity


def test_the_list_is_repeated():
    assert len(read(programme=[SLIDE, FASTER], repeat=3).segments) == 6


def test_fresh_without_a_dashpot():
    assert read(GLASSY, programme=[SLIDE], start="fresh").start == "fresh"


def test_an_indentation_over_time(tmp_path):
    (tmp_path / "d.csv").write_text("0, 1e-5\n1, 2e-5\n")
    table = {"programme": [SLIDE], "control": "indentation", "indentation_file": "d.csv"}
    scene = read_scene_table(table, tmp_path, (KELVIN,))
    assert scene.indentation_history == ((0.0, 1.0), (1e-5, 2e-5))
    assert not scene.uses_indentation


PROGRAMME = "scene.programme=[{slide={velocity=0.1, distance=1e-3}}, {hold={duration=[1, 2]}}]"


def test_axes_of_a_study_are_those_of_its_scene():
    text = small_study().text
    assert '"velocity"' in text
    study = small_study(
        PROGRAMME,
        "scene.control=indentation",
        "grid={hurst=0.7, spacing=1e-4, roughness=1e-5, prescribed_indentation=[0, 1e-5]}",
        text=SMALL,
    )
    assert study.axes[6:] == ("prescribed_indentation", "hold")
    assert study.grid["hold"] == (1.0, 2.0)
    assert study.grid["velocity"] == (0.1,)
    assert study.grid["velocity_step"] == (0.0,)
    assert math.isnan(study.grid["normal_force"][0])
    assert study.shape == (1, 1, 1, 1, 1, 1, 2, 2)


SMALL = """
study.realizations = 4
material = {shear_modulus = 1e7, relaxation_time = 1e-3}
surface.length = 0.01
"""


SLOW, FAST = SlideSegment(Velocity(0.1), 1e-3), SlideSegment(Velocity(0.2), 1e-3)
EVERYTHING = (SLOW, FAST, HoldSegment((1.0,)), SLOW, Oscillate(Velocity(0.1), 1e-4, 10.0, 3))


@pytest.mark.parametrize("name", QUANTITIES)
def test_a_full_programme_of_one_line_can_be_asked_for_everything(name):
    scene = Scene(programme=EVERYTHING)
    if name in ("stick_slip", "slip_events"):
        scene = Scene(programme=(SLOW,), drive=Spring(1e4))
    assert unavailable_reason(name, scene, {"": KELVIN}, single_line=True) == ""


def test_of_a_line_on_a_spring_there_is_what_its_drive_tells():
    missing = reasons(Scene(programme=(SLOW, HoldSegment((1.0,)), FAST), drive=Spring(1e4)))
    available = {"steady", "persson", "model_ratio", "trace", "healing", "stick_slip", "energy"}
    assert set(QUANTITIES) - missing == available


def reasons(scene, material=KELVIN, single_line=False):
    return {
        name for name in QUANTITIES if unavailable_reason(name, scene, {"": material}, single_line)
    }


def test_the_scene_of_the_paper_has_no_programme():
    of_programmes = {
        "trace",
        "stick_slip",
        "slip_events",
        "loop",
        "cycle_mean",
        "healing",
        "energy",
        "contact_lengths",
    }
    assert reasons(Scene()) == of_programmes | {"snapshots", "state"}


def test_without_a_dashpot_nothing_jumps():
    of_springs = {"stick_slip", "slip_events"}
    assert reasons(Scene(programme=EVERYTHING), GLASSY, single_line=True) == {"jump"} | of_springs


def test_what_is_defined_at_a_normal_force():
    scene = Scene(programme=EVERYTHING, control="indentation")
    left = set(QUANTITIES) - reasons(scene, single_line=True)
    assert left == {
        "models",
        "trace",
        "loop",
        "cycle_mean",
        "energy",
        "contact_lengths",
        "snapshots",
        "state",
    }


def test_a_repeated_list_meets_itself():
    once, twice = (Scene(programme=(SLOW, HoldSegment((1.0,))), repeat=n) for n in (1, 2))
    assert "healing" in reasons(once)
    assert "healing" not in reasons(twice)


def test_quantities_come_in_their_own_order():
    study = small_study('scene.quantities=["relaxation","steady"]')
    assert study.scene.quantities == ("steady", "relaxation")


def test_what_is_asked_for_is_judged():
    assert accuracy_estimates(("steady", "jump", "relaxation", "models")) == (
        "mu_1",
        "jump",
        "relaxation_rate",
    )
    assert accuracy_estimates(("jump",)) == ("jump",)
