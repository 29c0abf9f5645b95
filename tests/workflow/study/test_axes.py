"""The table of axes: what a value of one changes, and which tables may hold several values."""

from elastomer_friction.workflow.study.axes import (
    AXES,
    EVERY_AXIS,
    Axis,
    Parts,
    axes_of,
)
from elastomer_friction.workflow.study.effects import HoldSegment, Material, Scene
from elastomer_friction.workflow.study.surfaces import Surface
from tests.support.small import HOLDING, PROGRAMME, small_study

PARTS = Parts(
    Material(1e6, 1e-3), Surface(0.01), Scene(programme=(HoldSegment((1.0, 2.0), several=True),))
)


def test_an_axis_changes_its_own_part_alone():
    stiff = Axis("shear_modulus", "Pa", "shear modulus", "material").changed(PARTS, 3e6)
    assert stiff == PARTS._replace(material=Material(3e6, 1e-3))
    held = EVERY_AXIS["hold"].changed(PARTS, 2.0)
    assert held == PARTS._replace(scene=Scene(programme=(HoldSegment((2.0,)),)))


def test_parts_are_those_of_every_point_the_last_axis_fastest():
    study = small_study(PROGRAMME, text=HOLDING)
    assert axes_of(study.grid, "material", "scene") == ["temperature", "hold"]
    assert axes_of(study.grid, "grid") == list(AXES)
    found = study.parts("", ["temperature", "hold"])
    values = [(own.material.temperature, own.scene.segments[1].durations) for own in found]
    assert values == [(10.0, (1e-3,)), (10.0, (1e-2,)), (20.0, (1e-3,)), (20.0, (1e-2,))]
