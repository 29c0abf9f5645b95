"""Keys as their users see them: in sentences, in the words of their checks, in the JSON schema."""

import datetime
import re
import tomllib
from pathlib import Path

import jsonschema
import pytest

from elastomer_friction.workflow.study.read import known_studies
from elastomer_friction.workflow.study.schema import study_schema
from elastomer_friction.workflow.study.scripts import BUILT_IN_STUDIES, load_script
from elastomer_friction.workflow.study.settings import default_of, values_of
from elastomer_friction.workflow.study.tables import ALL_TABLES, TABLES
from tests.support.small import TEXT

KEYS = [
    pytest.param(key, id=f"{table}.{name}")
    for table, keys in ALL_TABLES.items()
    for name, key in keys.items()
]
NUMBERS = ("a number", "a whole number", "two numbers", "a list of numbers")


PAGE = Path(__file__).parents[3].joinpath("docs/reference/measures.md").read_text(encoding="utf-8")
ENTRY = re.compile(r"^### (\w+): measure\.(\w+)\n\n\*(.*): (.*)\.\*\n\n(.*)$", re.MULTILINE)
TABLES_OF = {
    path.parent.name: tomllib.loads(path.read_text(encoding="utf-8"))
    for path in BUILT_IN_STUDIES.glob("*/study.toml")
}
MEASURED = [
    (name, key, value)
    for name, tables in TABLES_OF.items()
    for key, value in tables.get("measure", {}).items()
]


def test_the_page_of_measured_studies_has_every_key_once():
    actual = [each[:2] for each in ENTRY.findall(PAGE)]
    assert len(actual) == PAGE.count("\n### ") > 0
    assert sorted(actual) == sorted((name, key) for name, key, _ in MEASURED)


@pytest.mark.parametrize(("name", "key", "value"), MEASURED)
def test_a_key_of_a_measured_study_is_described_with_its_values_at_every_scale(name, key, value):
    (entry,) = (each for each in ENTRY.findall(PAGE) if each[:2] == (name, key))
    values = values_of(load_script(BUILT_IN_STUDIES / name / "measure.py").SETTINGS[key])
    scales = {
        scale: own["measure"][key]
        for scale, own in TABLES_OF[name]["scales"].items()
        if key in own["measure"]
    }
    assert entry[2].lower() == values
    assert re.findall(r"at scale (\w+)", entry[3]) == list(scales)
    assert [float(n) for n in re.findall(r"`(.+?)`", entry[3])] == [value, *scales.values()]
    assert entry[4].endswith(".")


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
