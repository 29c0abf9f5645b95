"""Every key that a study may have is described: in sentences, with what doubling it does."""

import tomllib

import pytest

from elastomer_friction.workflow.study.described import described_measures
from elastomer_friction.workflow.study.scripts import OWN
from elastomer_friction.workflow.study.settings import default_of, values_of
from elastomer_friction.workflow.study.tables import EVERY_TABLE, HEAD
from elastomer_friction.workflow.study.variants import COMPARE

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
    assert "`[10, 100, 1000]` in its study.toml" in default_of(MEASURES["scaling"]["workers"])
