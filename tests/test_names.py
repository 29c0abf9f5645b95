"""No public name and no file name occurs twice in the program."""

import ast
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parents[1]
ROOMS = ("kernels", "workflow", "studies")

# Names that may occur more than once, with the reason.
CONTRACT_FILES = {
    "__init__": "the name that Python gives to a package",
    "__main__": "the name that Python gives to what a package runs",
    "figure": "a study's figure.py is found by its name",
    "claims": "a study's claims.py is found by its name",
    "measure": "a study's measure.py is found by its name",
    "cases": "every body has its cases, in a file of this name",
    "contact": "every body has its contact, in a file of this name",
    "surface": "a rough surface, as a study gives it and as a kernel samples it",
}
CONTRACT_NAMES = {
    "draw": "what figure.py of every study defines",
    "measure": "what measure.py of a study defines",
    "outline": "what measure.py of a study may define",
    "table": "what measure.py of a study may define",
    "run_case": "every body takes the same case, in its own cases.py",
    "Surface": "a rough surface, as a study gives it and as a kernel samples it",
}


def modules() -> list[Path]:
    return [path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))]


def public(path: Path) -> set[str]:
    """Return the names of the public classes and functions of a module."""
    kinds = (ast.ClassDef, ast.FunctionDef)
    return {
        node.name
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, kinds) and not node.name.startswith("_")
    }


def twice(words) -> set[str]:
    """Return the words in two or more places. words : pairs of a place and its words."""
    places = defaultdict(list)
    for path, names in words:
        for word in names:
            places[word].append(path)
    return {word for word, where in places.items() if len(where) > 1}


def test_no_public_name_is_defined_in_two_modules() -> None:
    repeated = twice((path, public(path)) for path in modules())
    assert repeated == set(CONTRACT_NAMES)


def test_no_file_name_stands_twice() -> None:
    repeated = twice((path, [path.stem]) for path in modules())
    assert repeated == set(CONTRACT_FILES)
