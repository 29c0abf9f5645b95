"""Every refusal in tests/refusals.md names its key, value and remedy, and the list is complete.

The examples are changes of the small study (small.py), separated by "; ": settings as for --set,
or `without TABLE.KEY`; or one `--scale NAME`, or `file TEXT` for the whole file.
"""

import ast
import re
from pathlib import Path

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.plan import make_plan
from tests.support.documents import without
from tests.support.small import TEXT, small_study

ROOT = Path(__file__).resolve().parents[3]
STUDY = ("axes", "cluster", "grid", "numerics", "read", "settings", "study", "tables", "variants")
EFFECTS = (
    "branches",
    "heat_keys",
    "material",
    "quantities",
    "scene",
    "scene_effects",
    "segments",
    "shearing",
    "shifting",
)
DOCUMENT = ROOT / "tests" / "refusals.md"
SURFACES = ("raw_lines", "files", "gaps", "positions", "profile", "table", "text_lines")
ROOMS = {"study": STUDY, "study/effects": EFFECTS, "study/surfaces": SURFACES}
CHECKED = (
    "plan/problems",
    "plan/scaled_effects",
    "simulate/recorded_steps",
    *(f"{room}/{name}" for room, names in ROOMS.items() for name in names),
)
# Functions whose refusals are tested elsewhere: find_study lists all studies (test_refusals.py),
# and the small study has neither measured lines nor a scene from Python (test_study.py).
ELSEWHERE = {"settle_body", "find_study", "read_grid_study", "_lines_in_blocks"}
# Refusals of arrays, netCDF, profiles from Python and missing packages are tested in
# tests/workflow/study/surfaces; their terms are among the other refusals.
ELSEWHERE |= {"_read_npy", "_variables", "_read_with_surface_topography"}
ELSEWHERE |= {
    "profile_of_array",
    "map_of_lines",
    "_check_finite",
    "check_load",
    "read_scene",
}


def _module(path):
    """Return "room/file" for the path of a module, with the rooms that it is nested in."""
    parts = Path(str(path)).with_suffix("").parts
    return (
        "/".join(parts[len(parts) - parts[::-1].index("workflow") :]) if "workflow" in parts else ""
    )


def rows(title):
    """Return the cells of the tables below a title."""
    text = DOCUMENT.read_text(encoding="utf-8").split(f"## {title}\n")[1].split("\n## ")[0]
    tables = re.findall(r"^\|[^\n]*\n\|[-|]+\n((?:\|[^\n]*\n)+)", f"{text}\n", re.MULTILINE)
    lines = "".join(tables).splitlines()
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines]


REFUSALS = rows("Refusals of a study")


def refuse(example):
    """Return (message, places where it was raised) of a refused example."""
    text, settings, scale = TEXT, [], None
    if example.startswith("file "):
        text = example.removeprefix("file ").replace("[ x 5000", "[" * 5000)
    elif example.startswith("--scale "):
        scale = example.removeprefix("--scale ")
    else:
        parts = example.split("; ")
        left_out = [part.removeprefix("without ") for part in parts if part.startswith("without ")]
        settings = [part for part in parts if not part.startswith("without ")]
        text = without(*left_out)
    with pytest.raises(UserError) as error:
        make_plan(small_study(*settings, text=text, scale=scale))
    message = re.sub(r"/\S*/(?=\w+\.(toml|csv))", "", str(error.value))
    places = {(_module(entry.path), entry.lineno + 1) for entry in error.traceback}
    return message, places


def terms_of(cell):
    """Return the terms of a cell, each of them in backticks."""
    return re.findall(r"`(.*?)`", cell)


def holds(text, term):
    """Return whether a term stands in a text as a whole word or number."""
    return re.search(rf"(?<![\w.]){re.escape(term)}(?![\w])", text) is not None


@pytest.mark.parametrize("row", REFUSALS, ids=lambda row: row[0])
def test_a_refusal_names_its_key_value_and_remedy_in_one_line(row):
    example, key_and_value, remedy = row
    message, _ = refuse(example.strip("`"))
    key_and_value = key_and_value.strip("`")
    assert message.startswith(key_and_value)
    assert "\n" not in message
    rest = message.removeprefix(key_and_value)
    assert terms_of(remedy)
    assert [term for term in terms_of(remedy) if not holds(rest, term)] == [], message


def raised(module):
    """Return the source lines over which ``raise UserError`` statements of a module stretch."""
    tree = ast.parse((ROOT / "workflow" / f"{module}.py").read_text(encoding="utf-8"))
    return [
        range(node.lineno, (node.end_lineno or node.lineno) + 1)
        for part in tree.body
        if getattr(part, "name", None) not in ELSEWHERE
        for node in ast.walk(part)
        if isinstance(node, ast.Raise) and re.search("UserError|refused|invalid", ast.unparse(node))
    ]


def test_no_refusal_is_missing_from_the_table():
    seen = set().union(*(refuse(row[0].strip("`"))[1] for row in REFUSALS))
    missing = [
        f"{module}.py:{lines[0]}"
        for module in CHECKED
        for lines in raised(module)
        if not any((module, line) in seen for line in lines)
    ]
    assert not missing


def messages():
    """Return all strings of the source; a replacement field of an f-string is left out."""
    for path in ROOT.glob("[kw]*/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.JoinedStr):
                pieces = [part for part in node.values if isinstance(part, ast.Constant)]
                yield "".join(str(part.value) for part in pieces)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value


def test_other_refusals_name_their_terms_in_one_message_of_the_source():
    texts = list(messages())
    others = rows("Other refusals")
    assert others
    for where, needed, cell in others:
        assert needed.endswith("."), where
        terms = terms_of(cell)
        assert terms, where
        assert any(all(term in text for term in terms) for text in texts), (where, terms)
