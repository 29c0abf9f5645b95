"""Whatever a TOML file holds, it is read as a study or refused with one line."""

import copy
import json
import tomllib

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.workflow.small import TEXT, small_study
from workflow.errors import UserError
from workflow.reader import TABLES
from workflow.study import Study

NAMES = sorted({key for keys in TABLES.values() for key in keys} | {"smoke", "x y", "linspace"})
NUMBERS = st.one_of(
    st.integers(-(2**70), 2**70),
    st.floats(1e-12, 1e12),
    st.floats(-1e3, 1e3, allow_subnormal=False),
    st.sampled_from([0.0, float("nan"), float("inf"), -float("inf"), 1, 2, 4, 0.5]),
)
SCALARS = st.one_of(
    NUMBERS,
    st.booleans(),
    st.sampled_from(["", "auto", "steady", "exponential", "modal", "a\nb", "µ", "'"]),
)
SPACED = st.builds(
    lambda kind, first, last, count: {kind: [first, last, count]},
    st.sampled_from(["linspace", "geomspace"]),
    NUMBERS,
    NUMBERS,
    st.integers(-2, 50),
)
VALUES = st.one_of(
    SCALARS,
    st.lists(SCALARS, max_size=3),
    SPACED,
    st.dictionaries(st.sampled_from(NAMES), st.one_of(SCALARS, st.lists(SCALARS)), max_size=2),
)
PLACES = st.tuples(st.sampled_from([*TABLES, "compare", "scales", "other"]), st.sampled_from(NAMES))


def toml(value):
    """Return ``value`` as inline TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(toml(entry) for entry in value) + "]"
    if isinstance(value, float):
        return repr(value)
    return json.dumps(value)


def read(tables, scale):
    """Return the study that ``tables`` make, or the message they are refused with."""
    text = "\n".join(f"{json.dumps(key)} = {toml(value)}" for key, value in tables.items())
    try:
        return small_study(text=text, scale=scale)
    except UserError as error:
        return str(error)


def check(outcome):
    """Assert that ``outcome`` is a study or a message of one line."""
    assert isinstance(outcome, Study) or (outcome and "\n" not in outcome)


@settings(max_examples=150, deadline=None)
@given(st.lists(st.tuples(PLACES, VALUES), min_size=1, max_size=3), st.booleans())
def test_a_study_with_random_changes_is_read_or_refused(changes, scaled):
    tables = copy.deepcopy(tomllib.loads(TEXT))
    for (table, key), value in changes:
        tables.setdefault(table, {})[key] = value
    check(read(tables, "wide" if scaled else None))


@settings(max_examples=50, deadline=None)
@given(st.dictionaries(st.sampled_from([*TABLES, "compare", "other"]), VALUES, max_size=4))
def test_random_tables_are_read_or_refused(tables):
    check(read(tables, None))


def test_the_text_written_for_the_fuzz_is_the_study_it_came_from():
    outcome = read(tomllib.loads(TEXT), None)
    assert isinstance(outcome, Study)
    assert outcome.grid == small_study().grid
