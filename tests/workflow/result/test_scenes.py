"""Variables of scenes: their units follow from how they are scaled."""

import pytest

from elastomer_friction.workflow.result.variables import SCENES

# Of h, dx, tau and 4 G L: metres, seconds, newtons.
BASE = {"roughness": "m", "spacing": "m", "tau": "s", "stiffness": "N m-1"}
UNITS = {(1, 0, 0): "m", (0, 1, 0): "s", (1, -1, 0): "m s-1", (0, -1, 0): "s-1", (0, 0, 0): "1"}
UNITS |= {(0, 0, 1): "N", (1, 0, 1): "J"}
SCALED = {name: variable for name, variable in SCENES.items() if variable.scaling}


@pytest.mark.parametrize("name", SCALED)
def test_units_are_those_of_the_scaling(name):
    powers = dict(SCALED[name].scaling)
    newtons = powers.pop("stiffness", 0)
    metres = powers.pop("roughness", 0) + powers.pop("spacing", 0) - newtons
    seconds = powers.pop("tau", 0)
    assert not powers
    assert SCALED[name].units == UNITS[metres, seconds, newtons]
