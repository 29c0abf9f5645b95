"""Keys as their users see them: in sentences, in the words of their checks, in the JSON schema."""

import datetime
import tomllib

import jsonschema
import pytest

from elastomer_friction.workflow.study.read import known_studies
from elastomer_friction.workflow.study.schema import described_measures, study_schema
from elastomer_friction.workflow.study.scripts import OWN
from elastomer_friction.workflow.study.settings import (
    as_toml,
    default_of,
    values_of,
)
from elastomer_friction.workflow.study.tables import EVERY_TABLE, HEAD, TABLES
from elastomer_friction.workflow.study.variants import COMPARE
from tests.support.small import TEXT

MEASURES = described_measures()
KEYS = [
    pytest.param(key, id=f"{table}.{name}")
    for table, keys in {**EVERY_TABLE, **MEASURES}.items()
    for name, key in keys.items()
]
NUMBERS = ("a number", "a whole number", "two numbers", "a list of numbers")


def test_every_key_of_a_comparison_is_among_those_of_the_tables():
    assert {*HEAD, *COMPARE} <= {key for keys in EVERY_TABLE.values() for key in keys}


def test_every_study_with_a_table_measure_is_described():
    tables = {
        path.parent.name: tomllib.loads(path.read_text(encoding="utf-8"))
        for path in OWN.glob("*/study.toml")
    }
    measured = {name: set(table["measure"]) for name, table in tables.items() if "measure" in table}
    assert measured
    assert {name: set(keys) for name, keys in MEASURES.items()} == measured


@pytest.mark.parametrize("key", KEYS)
def test_a_key_is_described_in_sentences(key):
    assert key.means
    for text in filter(None, (key.means, key.doubled)):
        assert text[0].isupper() or text[0] == "`"
        assert text.endswith(".")
    assert values_of(key)
    assert default_of(key)
    if values_of(key).startswith(NUMBERS):
        assert "oubl" in key.doubled  # what changes when it is doubled


def test_the_values_are_those_of_the_study_at_every_scale():
    points = default_of(MEASURES["accuracy"]["points"])
    assert points == "required; `17` in its study.toml, `3` at scale smoke"


def test_lists_of_numbers_and_of_texts_are_as_toml_has_them():
    lists = [1, 10, 1_000_000], [0.2, 2e7], ["fig7", "grid6d"]
    written = "\n".join(f"k{i} = {as_toml(one)}" for i, one in enumerate(lists))
    assert list(tomllib.loads(written).values()) == list(lists)


CHECK = jsonschema.Draft7Validator(study_schema())
EVERY_KEY = [(table, key) for table, keys in TABLES.items() for key in keys]


def with_value(table: str, key: str, value: object) -> dict:
    """Return the small study with one value."""
    tables = tomllib.loads(TEXT)
    tables.setdefault(table, {})[key] = value
    return tables


def test_it_is_a_schema_and_every_study_keeps_it():
    jsonschema.Draft7Validator.check_schema(study_schema())
    for path in known_studies().values():
        CHECK.validate(tomllib.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(("table", "key"), EVERY_KEY)
def test_no_key_takes_a_date_at_any_scale(table, key):
    tables = with_value(table, key, datetime.date(2014, 7, 24))
    assert not CHECK.is_valid(tables)
    assert not CHECK.is_valid(tomllib.loads(TEXT) | {"scales": {"wide": {table: tables[table]}}})


@pytest.mark.parametrize("table", TABLES)
def test_a_typo_is_refused(table):
    assert CHECK.is_valid(with_value("study", "seed", 3))
    assert not CHECK.is_valid(with_value(table, "hurts", 1))


REFUSED = [
    ("grid", "hurst", 1.2),
    ("grid", "velocity", {"logspace": [1, 2, 3]}),
    ("grid", "velocity", {"linspace": [1, 2]}),
    ("grid", "velocity", {"linspace": [1, 2, 20_000]}),
    ("grid", "velocity", [0.1, 0.1]),
    ("grid", "velocity_step", -1),
    ("numerics", "steps_per_spacing", 0),
    ("numerics", "scheme", "rk4"),
    ("material", "branches", [[5e6, 1e-2, 1.0]]),
    ("material", "wlf", {"c1": 8.86, "c2": -1.0, "reference": 20}),
    ("material", "arrhenius", {"activation_energy": 0, "reference": 20}),
    ("material", "shifts", [[20, 0]]),
    ("scene", "quantities", ["stedy"]),
    ("scene", "programme", [{"jump": {"velocity": 0.1}}]),
    ("scene", "programme", [{"hold": {"duration": 1}, "file": "a.csv"}]),
    ("scene", "programme", [{"slide": {"velocity": 0, "distance": 1e-3}}]),
    ("cluster", "where", "moon"),
    ("cluster", "memory", "much"),
    ("compare", "a b", {"samples": 16}),
    ("compare", "coarse", {"temperature": 20}),
]


@pytest.mark.parametrize(("table", "key", "value"), REFUSED)
def test_what_the_reader_refuses_is_refused(table, key, value):
    assert not CHECK.is_valid(with_value(table, key, value))


def test_every_key_of_a_comparison_is_there():
    compared = study_schema()["properties"]["compare"]["patternProperties"]
    (table,) = compared.values()
    assert table["properties"].keys() == COMPARE.keys()
    assert all("description" in each for each in table["properties"].values())
