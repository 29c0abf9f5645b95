"""Every variable of a result is described, and every flag explained."""

import pytest

from elastomer_friction.workflow.reduce import MODEL_MEANINGS
from elastomer_friction.workflow.result.reference import of_tables
from elastomer_friction.workflow.result.reference.of_tables import described_variables
from elastomer_friction.workflow.result.variables import FLAGS, VARIABLES

ALL = [variable for section in described_variables().values() for variable in section]


def test_every_variable_is_described_once():
    assert sorted(variable.name for variable in ALL) == sorted(VARIABLES)


@pytest.mark.parametrize("variable", ALL, ids=lambda variable: variable.name)
def test_a_variable_is_described_in_sentences(variable):
    assert variable.text.endswith(".")
    assert variable.sign.endswith(".") or not variable.sign
    assert bool(variable.flags) == (variable.name in FLAGS)


def test_a_variable_without_a_meaning_is_an_error(monkeypatch):
    monkeypatch.setitem(of_tables.SECTIONS, "The jump (quantity `jump`)", {})
    with pytest.raises(KeyError, match="jump"):
        described_variables()


def test_flags_begin_with_failed():
    (best,) = (variable for variable in ALL if variable.name == "best_model")
    assert best.flags == ("failed", *MODEL_MEANINGS.split())
