"""Every key that a study may have is described: in sentences, with what doubling it does."""

import pytest

from elastomer_friction.workflow.study.measured import HEAD  # of every kind of study
from elastomer_friction.workflow.study.reference import tables
from elastomer_friction.workflow.study.reference.tables import PAIRS, described_tables
from elastomer_friction.workflow.study.study import TABLES
from elastomer_friction.workflow.study.variants import COMPARE

KEYS = [(table, key) for table, keys in described_tables().items() for key in keys]


def test_every_table_of_a_study_is_described():
    assert {*TABLES, "cluster"} <= PAIRS.keys()
    known = {key.name for table, key in KEYS if "." not in table}
    assert {*HEAD, *COMPARE} <= known


@pytest.mark.parametrize(("table", "key"), KEYS, ids=[f"{t}.{k.name}" for t, k in KEYS])
def test_a_key_is_described_in_sentences(table, key):
    for text in (key.means, key.changes):
        assert text[0].isupper() or text[0] == "`"
        assert text.endswith(".")
    assert key.values
    assert key.default
    if key.values.startswith(("a number", "a whole number", "two numbers")):
        assert "oubl" in key.changes  # what changes when it is doubled


def test_a_key_without_a_text_is_an_error(monkeypatch):
    keys, texts = PAIRS["grid"]
    fewer = {name: texts[name] for name in texts if name != "hurst"}
    monkeypatch.setitem(tables.PAIRS, "grid", (keys, fewer))
    with pytest.raises(KeyError, match="hurst"):
        described_tables()
