"""The table of axes: what a value of one changes, and which tables may hold several values."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.axes import (
    AXES,
    EVERY_AXIS,
    Axis,
    Parts,
    axes_of,
    separated,
    with_lists,
)
from elastomer_friction.workflow.study.effects import HoldSegment, Material, Scene
from elastomer_friction.workflow.study.settings import Key, positive
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


def test_keys_of_axes_and_no_others_may_have_several_values():
    keys = with_lists("material", {"temperature": Key(positive), "branches": Key(positive)})
    assert keys["temperature"].check("T", [1, 2]) == (1.0, 2.0)
    assert keys["temperature"].check("T", 3) == 3.0
    with pytest.raises(UserError, match="must be a finite number"):
        keys["branches"].check("g", [1, 2])
    assert with_lists("surface", keys) == keys


def test_the_first_of_several_values_stays_in_the_table():
    tables = {"material": {"temperature": (1.0, 2.0)}, "surface": {}, "scene": {}, "grid": {}}
    single, several = separated(tables)
    assert single == tables | {"material": {"temperature": 1.0}}
    assert several == {"temperature": (1.0, 2.0)}
    assert separated(single) == (single, {})
