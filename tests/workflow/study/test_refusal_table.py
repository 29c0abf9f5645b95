"""tests/refusals.md: every refusal it lists is refused with these words, and none is missing.

The examples are changes of the small study (small.py), apart by "; ": settings as for --set and
`without TABLE.KEY`; or `--scale NAME`, or `file TEXT` for the whole file.
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
EFFECTS = ("branches", "material", "quantities", "scene", "segments", "shifting")
DOCUMENT = ROOT / "tests" / "refusals.md"
SURFACES = ("as_read", "files", "gaps", "positions", "profile", "table", "text_lines")
ROOMS = {
    "study": STUDY,
    "study/effects": EFFECTS,
    "study/surfaces": SURFACES,
}
CHECKED = (
    "plan/problems",
    "simulate/kept",
    *(f"{room}/{name}" for room, names in ROOMS.items() for name in names),
)
# Of "find_study" the answers name all studies (test_refusals.py); the others are refusals of a
# scene and of measured lines, which the small study is not (test_study.py).
ELSEWHERE = {"find_study", "read_grid_study", "_lines_in_blocks"}
# Of arrays and netCDF, of profiles from Python, and where a package is not installed
# (tests/workflow/study/surfaces); their words are among the other refusals.
ELSEWHERE |= {"_npy", "_variables", "_with_surface_topography"}
ELSEWHERE |= {
    "given_profile",
    "given_map",
    "read_map",
    "given_heights",
    "check_finite",
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


@pytest.mark.parametrize("row", REFUSALS, ids=lambda row: row[0])
def test_the_refusal_has_the_words_of_the_table(row):
    example, answer = row
    assert refuse(example.strip("`"))[0] == answer.strip("`")


def raised(module):
    """Return the source lines over which ``raise UserError`` statements of a module stretch."""
    tree = ast.parse((ROOT / "workflow" / f"{module}.py").read_text(encoding="utf-8"))
    return [
        range(node.lineno, (node.end_lineno or node.lineno) + 1)
        for part in tree.body
        if getattr(part, "name", None) not in ELSEWHERE
        for node in ast.walk(part)
        if isinstance(node, ast.Raise) and "UserError" in ast.unparse(node)
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


def test_other_refusals_have_the_words_of_the_source():
    source = "".join(path.read_text(encoding="utf-8") for path in ROOT.glob("[kw]*/**/*.py"))
    source = re.sub(r'"\s*\n\s*f?"', "", source)
    others = rows("Other refusals")
    assert others
    for where, needed, words in others:
        assert needed.endswith("."), where
        for part in re.split(r"…", words.strip("`")):
            assert part.strip() in source, (where, part)
