"""The JSON schema of study.toml takes what the reader takes, and refuses what it refuses."""

import datetime
import tomllib

import jsonschema
import pytest

from elastomer_friction.workflow.study.read import known_studies
from elastomer_friction.workflow.study.schema import study_schema
from elastomer_friction.workflow.study.tables import TABLES
from elastomer_friction.workflow.study.variants import COMPARE
from tests.support.small import TEXT

CHECK = jsonschema.Draft7Validator(study_schema())
KEYS = [(table, key) for table, keys in TABLES.items() for key in keys]


def with_value(table: str, key: str, value: object) -> dict:
    """Return the small study with one value."""
    tables = tomllib.loads(TEXT)
    tables.setdefault(table, {})[key] = value
    return tables


def test_it_is_a_schema_and_every_study_keeps_it():
    jsonschema.Draft7Validator.check_schema(study_schema())
    for path in known_studies().values():
        CHECK.validate(tomllib.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(("table", "key"), KEYS)
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
