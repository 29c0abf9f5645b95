"""Checks of settings: a value of the wrong type, a typo and a missing key are named."""

import pytest

from elastomer_friction.workflow.study.axes import AXES
from elastomer_friction.workflow.study.tables import TABLES
from elastomer_friction.workflow.study.variants import COMPARE
from tests.support.documents import without
from tests.support.small import complaint

KNOWN = {**TABLES, "compare.coarse": COMPARE}


@pytest.mark.parametrize("key", [f"{table}.{key}" for table in KNOWN for key in KNOWN[table]])
def test_no_key_takes_a_date(key):
    assert complaint(f"{key}=1979-05-27").startswith(f"{key} = ")


@pytest.mark.parametrize("table", KNOWN)
def test_a_typo_in_a_key_is_answered_with_the_known_ones(table):
    said = complaint(f"{table}.hurts=1")
    end = "; did you mean hurst?" if "hurst" in KNOWN[table] else ""
    assert said == f"{table}.hurts: unknown key; known are {', '.join(KNOWN[table])}{end}"


def test_a_typo_in_a_table_is_answered_with_the_known_ones():
    assert complaint("gird.hurst=1").startswith("gird: unknown key; known are study, material, ")


REQUIRED = [
    *("study.realizations", "material.shear_modulus", "material.relaxation_time", "surface.length"),
    *(f"grid.{axis}" for axis in AXES),
]


@pytest.mark.parametrize("where", REQUIRED)
def test_missing_key_is_named(where):
    assert complaint(text=without(where)) == f"{where}: missing"
