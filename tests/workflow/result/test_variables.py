"""Variables of a result: declarations, descriptions, units and standard errors."""

import re
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.reduce.fits import NEGLIGIBLE
from elastomer_friction.workflow.reduce.jackknife import errors_needed
from elastomer_friction.workflow.result.variables import (
    AUXILIARY,
    AXIS_ATTRIBUTES,
    FLAGS,
    SCENES,
    VARIABLES,
    declared,
)
from elastomer_friction.workflow.study import ALL_AXES, COMMON_AXES

# tests/workflow/reduce/test_model_ratio.py, tests/workflow/reduce/test_persson.py
# and test_point_quantities.py, tests/workflow/scene/test_heat.py
OF_BODIES = {
    "model_ratio",
    "model_realizations",
    "mu_persson",
    "area_persson",
    "mu_persson_shear",
    "mu_persson_total",
    "mean_contact_pressure",
    "contact_temperature",
    "flash_temperature",
}
ACCURACY = {"accuracy_reached", "accuracy_status"}  # run/test_rounds.py


def test_every_declared_variable_is_there_as_it_is_declared_and_described(with_models):
    ours = with_models.variables.keys() - with_models.dims
    names = {re.sub("_error$|(?<!alpha)(?<!free)_bias$", "", str(n)) for n in ours}
    assert names == (set(VARIABLES) - ACCURACY - OF_BODIES - set(SCENES)) | {"tau"}
    for name, variable in ((name, with_models[name]) for name in sorted(ours - {"tau"})):
        assert variable.dtype == declared(name).dtype, name
        assert variable.dims == declared(name).dims, name
        error = f"{name}_error"
        expected = error if error in with_models else None
        assert variable.attrs.get("ancillary_variables") == expected
    for variable in with_models.variables.values():
        assert variable.attrs["units"]
        assert variable.attrs["long_name"]
    integers = {name for name, variable in VARIABLES.items() if variable.dtype != "float64"}
    assert set(FLAGS) - set(SCENES) < integers


def test_every_error_is_described_like_its_estimate(with_models):
    errors = [name for name in with_models.data_vars if str(name).endswith("_error")]
    assert len(errors) > 10
    for name in errors:
        error, estimate = with_models[name], with_models[name.removesuffix("_error")]
        assert error.attrs["units"] == estimate.attrs["units"]
        assert error.attrs["long_name"] == f"standard error of {estimate.attrs['long_name']}"


def test_fit_status_explains_its_codes(dataset):
    attributes = dataset["fit_status"].attrs
    meanings = attributes["flag_meanings"].split()
    assert meanings[:4] == ["failed", "fitted", "no_relaxation", "not_exponential"]
    assert list(attributes["flag_values"]) == list(range(-1, NEGLIGIBLE + 1))
    assert attributes["flag_values"].dtype == dataset["fit_status"].dtype
    assert len(meanings) == NEGLIGIBLE + 2
    for meaning in meanings[2:]:
        assert f"{meaning}: " in attributes["comment"]
    assert [errors_needed(blocks) > 3.0 for blocks in (14, 15)] == [True, False]
    assert "more with fewer than 15 blocks" in attributes["comment"]


def test_coordinates_are_in_si_units(with_models):
    assert float(with_models.tau) == 1e-3
    assert float(with_models.shear_modulus) == 1e7
    assert float(with_models.length) == 0.01
    np.testing.assert_allclose(with_models.q_max * with_models.spacing, np.pi)
    x = with_models.velocity * with_models.tau * with_models.q_max
    np.testing.assert_allclose(with_models.speed_ratio, x.broadcast_like(with_models.speed_ratio))
    assert set(AUXILIARY) <= set(VARIABLES)


def test_every_flag_says_what_its_values_mean():
    assert set(FLAGS) == {name for name, variable in VARIABLES.items() if variable.dtype == "int8"}


# Units by their powers of metre, second and newton.
UNITS = {(1, 0, 0): "m", (0, 1, 0): "s", (1, -1, 0): "m s-1", (0, -1, 0): "s-1", (0, 0, 0): "1"}
UNITS |= {(0, 0, 1): "N", (1, 0, 1): "J", (-2, 0, 1): "Pa"}
AXES = {"roughness": (1, 0, 0), "spacing": (1, 0, 0), "tau": (0, 1, 0)}
AXES |= {"stiffness": (-1, 0, 1), "modulus": (-2, 0, 1)}


SCALES = {str(variable.scaling): variable.scaling for variable in VARIABLES.values()}


@pytest.mark.parametrize("scale", SCALES.values(), ids=SCALES)
def test_units_are_those_of_the_scaling(scale):
    powers = sum(power * np.array(AXES[axis]) for axis, power in scale.powers.items())
    assert not scale.powers or UNITS[tuple(powers)] == scale.units


PAGE = Path(__file__).parents[3].joinpath("docs/reference/results.md").read_text(encoding="utf-8")
_, *PARTS = re.split(r"^### (\w+)\n", re.sub(r"^## .*\n", "", PAGE, flags=re.MULTILINE), flags=re.M)
ENTRIES = dict(zip(PARTS[::2], map(str.strip, PARTS[1::2]), strict=True))


def test_the_page_explains_every_variable_once_and_every_dimension():
    assert sorted(PARTS[::2]) == sorted(VARIABLES)
    for name, (unit, long_name) in AXIS_ATTRIBUTES.items():
        assert f"\n| `{name}` | {long_name} | {unit} |\n" in PAGE
    paragraph = " ".join(PAGE.partition("**Dimensions.**")[2].partition("\n\n")[0].split())
    assert re.findall("`(\\w+)`", paragraph) == list(ALL_AXES)


@pytest.mark.parametrize("name", VARIABLES)
def test_an_entry_begins_with_dimensions_unit_and_a_sentence(name):
    variable = VARIABLES[name]
    of_grid = set(COMMON_AXES) <= set(variable.dims)
    dims = ["Grid"] * of_grid + [
        f"`{d}`" for d in variable.dims if not (of_grid and d in COMMON_AXES)
    ]
    unit = "" if variable.scaling.units == "1" else f", in {variable.scaling.units}"
    place = f"*{' × '.join(dims) or 'A single number'}{unit}.*\n\n".removeprefix("*Grid.*\n\n")
    assert ENTRIES[name].startswith(place)
    text = ENTRIES[name].removeprefix(place).partition("\n")[0]
    assert re.fullmatch(r"[^*].*\.", text)


@pytest.mark.parametrize("name", FLAGS)
def test_an_entry_explains_flags_or_refers_to_another(name):
    other = re.search(r"\nIts flags are those of \[`(\w+)`\]\(#\1\)\.$", ENTRIES[name])
    if other:
        assert FLAGS[other[1]] == FLAGS[name]
        return
    meanings = dict(re.findall(r"(?:^|; )(\w+): ([^;]+)", VARIABLES[name].comment))
    rows = [
        f"`{flag}`: {meanings[flag]}" if flag in meanings else f"`{flag}`"
        for flag in FLAGS[name].split()
    ]
    table = "\n".join(f"| {value} | {row} |" for value, row in enumerate(rows))
    assert ENTRIES[name].endswith(f"\n| flag | meaning |\n|---|---|\n| −1 | `failed` |\n{table}")
