"""docs/model.md says where each equation stands: the function is there, and names its equation."""

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
    """Eqs. 7 to 11 define quantities and limits, which are measured or contained in eq. 12."""
    assert {number for number, *_ in FOUND} == {1, 2, 3, 4, 5, 6, 12, 13, 14, 15, 16}


def documented(file, name):
    """Return the docstring of a function or class of a file, or of a method of a class."""
    found = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    for part in name.split("."):
        (found,) = (node for node in found.body if getattr(node, "name", "") == part)
    return ast.get_docstring(found)


def numbers_in(text):
    """Return the numbers of equations that a text names: "eq. 3", "eqs. 1 and 2", "eqs. 3 to 5"."""
    found = set()
    for listed in re.findall(r"[Ee]qs?\. (\d+(?:(?:, | and | to )\d+)*)", text):
        first, *others = map(int, re.findall(r"\d+", listed))
        found |= set(range(first, others[-1] + 1)) if " to " in listed else {first, *others}
    return found


@pytest.mark.parametrize(("number", "file", "name"), FOUND)
def test_the_function_names_the_equation_that_it_states(number, file, name):
    assert number in numbers_in(documented(file, name))
