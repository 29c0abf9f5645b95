"""What a key takes is said as its check has it."""

import tomllib
from functools import partial

import pytest

from elastomer_friction.workflow.study.settings import (
    Key,
    as_text,
    as_toml,
    checked_values,
    choice,
    default_of,
    flag,
    integer,
    number,
    positive,
    values_of,
    within,
)


@pytest.mark.parametrize(
    ("check", "said"),
    [
        (positive, "a number above 0"),
        (number, "a number"),
        (flag, "`true` or `false`"),
        (as_text, "text"),
        (partial(within, least=0.0, most=1.0), "a number from 0 to 1"),
        (partial(integer, least=1), "a whole number, at least 1"),
        (partial(integer, least=8, most=9), "a whole number from 8 to 9"),
        (partial(choice, known=("a", "b", "c")), '`"a"`, `"b"` or `"c"`'),
        (partial(checked_values, positive), "a number above 0, or a list or range"),
        (lambda key, value: value, ""),
    ],
)
def test_a_check_in_words(check, said):
    assert values_of(Key(check)) == said


@pytest.mark.parametrize(
    ("default", "said"),
    [
        (0.01, "0.01"),
        (10_000, "10000"),
        (1_000_000, "1000000"),  # a whole number, where 1e+06 is none
        (True, "`true`"),
        ("line", '`"line"`'),
        ("", ""),
        (None, ""),
    ],
)
def test_a_default_as_toml_has_it(default, said):
    assert default_of(Key(number, default=default)) == said


def test_a_key_without_a_default_is_required():
    assert default_of(Key(number)) == "required"


def test_lists_of_numbers_and_of_texts_are_as_toml_has_them():
    lists = [1, 10, 1_000_000], [0.2, 2e7], ["fig7", "grid6d"]
    written = "\n".join(f"k{i} = {as_toml(one)}" for i, one in enumerate(lists))
    assert list(tomllib.loads(written).values()) == list(lists)
