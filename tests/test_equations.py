"""The functions that docs/model.md lists for each equation exist and name the equation."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
ROW = re.compile(r"^\| ([\d, ]+)(?: as printed)? \|[^|]*\|(.*)\|$", re.MULTILINE)
FOUND = [
    (number, *place.split("::"))
    for numbers, places in ROW.findall((ROOT / "docs" / "model.md").read_text(encoding="utf-8"))
    for place in re.findall(r"`(\S+\.py::\S+)`", places)
    for number in map(int, numbers.split(","))
]


def test_every_equation_that_is_computed_is_listed():
    """Eqs. 7 to 11 define quantities and limits that are measured, or contained in eq. 12."""
    assert {number for number, *_ in FOUND} == {1, 2, 3, 4, 5, 6, 12, 13, 14, 15, 16}


def documented(file, name):
    """Return the docstring of a function, class or method in a file."""
    definition = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    for part in name.split("."):
        (definition,) = (n for n in definition.body if getattr(n, "name", "") == part)
    return ast.get_docstring(definition)


def numbers_in(text):
    """Return the numbers of the equations in a text: "eq. 3", "eqs. 1 and 2", "eqs. 3 to 5"."""
    numbers = set()
    for listed in re.findall(r"[Ee]qs?\. (\d+(?:(?:, | and | to )\d+)*)", text):
        first, *others = map(int, re.findall(r"\d+", listed))
        numbers |= set(range(first, others[-1] + 1)) if " to " in listed else {first, *others}
    return numbers


@pytest.mark.parametrize(("number", "file", "name"), FOUND)
def test_the_function_names_the_equation_that_it_states(number, file, name):
    assert number in numbers_in(documented(file, name))
