"""Checks of settings: what passes comes out, what does not is named with its value."""

import pytest

from tests.support.small import TEXT, complaint
from workflow.errors import UserError
from workflow.study.checks import integer, positive


@pytest.mark.parametrize("value", [0, -1.5])
def test_positive_refuses_zero_and_below(value):
    with pytest.raises(UserError, match=rf"^material.G = {value}: must be greater than zero$"):
        positive("material.G", value)


@pytest.mark.parametrize("value", [1, 2.0, True, "3"])
def test_integer_refuses_what_is_not_a_whole_number_of_the_least(value):
    with pytest.raises(UserError, match="whole number, at least 2") as error:
        integer("study.n", value, 2)
    assert str(error.value).startswith(f"study.n = {value!r}")


TYPOS = {
    "material.shear_modulos": "shear_modulus, relaxation_time",
    "surface.lenght": "length, normalisation",
    "grid.hurts": "hurst, normal_force",
    "scene.quantity": "quantities, indentation_rate",
    "numerics.schema": "scheme, steps_per_spacing",
    "compare.coarse.schema": "scheme, steps_per_spacing",
    "gird.hurst": "study, material, surface, grid",
}


@pytest.mark.parametrize("key", TYPOS)
def test_typo_in_a_key_names_it_and_the_known_ones(key):
    message = complaint(f"{key}=1")
    assert message.startswith(key if not key.startswith("gird") else "gird: unknown")
    assert "unknown key; known are" in message
    assert TYPOS[key] in message


REQUIRED = {
    "study.realizations": "realizations = 4",
    "material.shear_modulus": "shear_modulus = 1e7",
    "material.relaxation_time": "relaxation_time = 1e-3",
    "surface.length": "length = 0.01",
    "grid.hurst": "hurst = [0.3, 0.7]",
    "grid.normal_force": "normal_force = [0.04, 0.4]\n",
    "grid.spacing": "spacing = 1e-4",
    "grid.roughness": "roughness = 1e-5",
    "grid.velocity": "velocity = [0.03, 0.1]",
    "grid.velocity_step": "velocity_step = 0.2",
}


@pytest.mark.parametrize("key", REQUIRED)
def test_missing_key_is_named(key):
    assert TEXT.count(REQUIRED[key]) == 1
    assert complaint(text=TEXT.replace(REQUIRED[key], "\n")) == f"{key}: missing"
