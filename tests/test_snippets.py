"""Fenced commands and snippets in the documents run as printed.

An HTML comment on the line before a block marks special blocks:

    <!-- file: PATH -->         the block is the file PATH, relative to the working folder
    <!-- needs: STUDY -->       it opens results/STUDY.nc, which is computed before, at low cost
    <!-- exhaustive -->         it takes long, and only make test-all runs it
    <!-- not run: REASON -->    it is checked, but not run
"""

import re
import shlex
import subprocess
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

import matplotlib as mpl
import pytest
from matplotlib import pyplot as plt

from elastomer_friction.workflow.cli import command_parser, main
from elastomer_friction.workflow.study import ALL_TABLES, known_studies

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
BLOCK = re.compile(
    r"^(?:<!-- (?P<mark>[^>]*) -->\n)?```(?P<language>\w*)\n(?P<text>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
PROGRAM = "elastomer-friction "
ROUGHLY = {"fig7": ("--scale", "smoke", "--set", "study.realizations=8")}  # by needed study


class Block(NamedTuple):
    """One fenced block of a page."""

    page: str
    line: int
    mark: str  # file, needs, exhaustive, not run; empty: none
    value: str  # text after the colon of the mark
    language: str
    text: str

    def __str__(self) -> str:
        """Return the place of the block."""
        return f"{self.page}:{self.line}"


def blocks(page: Path) -> list[Block]:
    """Return the fenced blocks of a page, in order."""
    text = page.read_text(encoding="utf-8")
    actual = []
    for match in BLOCK.finditer(text):
        mark, _, value = (match["mark"] or "").partition(": ")
        line = text.count("\n", 0, match.start()) + 1
        name = page.relative_to(ROOT).as_posix()
        actual.append(Block(name, line, mark, value, match["language"], match["text"]))
    return actual


def commands(text: str) -> list[str]:
    """Return the commands of a shell block, one line each, without comments."""
    lines = text.replace("\\\n", " ").splitlines()
    stripped = (re.sub(r"\s+#.*$", "", line).strip() for line in lines)
    return [line for line in stripped if line and not line.startswith("#")]


def run_block(block: Block, names: dict[str, Any]) -> None:
    """Run a block in the working folder. names : Python names defined on its page so far."""
    if block.mark == "file":
        path = Path(block.value)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(block.text, encoding="utf-8")
    elif block.language == "python":
        exec(compile(block.text, str(block), "exec"), names)
    elif block.language == "bash":
        for command in commands(block.text):
            _run(command)


def provide(study: str) -> None:
    """Compute results/STUDY.nc at low cost if it does not exist."""
    result = Path("results") / f"{study}.nc"
    if not result.is_file():
        assert main(["run", study, "--out", str(result), *ROUGHLY[study]]) == 0


def _run(command: str) -> None:
    if command.startswith(PROGRAM):
        assert main(shlex.split(command.removeprefix(PROGRAM))) == 0, command
    elif command.startswith("make "):  # dry run, as make needs an environment
        subprocess.run(["make", "-n", *shlex.split(command)[1:]], cwd=ROOT, check=True)
    else:
        subprocess.run(["bash", "-ec", command], check=True)


BLOCKS = [block for page in PAGES for block in blocks(page)]
MARKS = {"", "file", "needs", "exhaustive", "not run"}
# Commands inline and in tables, but not usage with options in brackets.
INLINE = re.compile(rf"(?:`|^ {{4}}){re.escape(PROGRAM)}([^`\n\[]*)(?:`|$)", re.MULTILINE)
RUN = sorted({block.page for block in BLOCKS if block.mark != "not run"})
USUAL = ("README.md",)  # pages that run in make test; the others take seconds


def ids(values: list) -> list[str]:
    """Return the names of blocks."""
    return [str(value) for value in values]


@pytest.mark.parametrize("block", BLOCKS, ids=ids(BLOCKS))
def test_a_block_is_of_a_known_kind(block: Block):
    assert block.language in {"bash", "python", "toml", "text"}
    assert block.mark in MARKS
    if block.language == "python":
        compile(block.text, str(block), "exec")
    if block.language == "toml":
        tables = tomllib.loads(block.text)
        for name in tables.keys() & ALL_TABLES.keys():
            assert tables[name].keys() <= ALL_TABLES[name].keys(), name


def told() -> list[tuple[str, str]]:
    """Return (page, command) for all commands of the program on all pages."""
    pairs = []
    for page in PAGES:
        name = page.relative_to(ROOT).as_posix()
        pairs += [(name, text) for text in INLINE.findall(page.read_text(encoding="utf-8"))]
    for block in BLOCKS:
        if block.language == "bash":
            pairs += [
                (block.page, command.removeprefix(PROGRAM))
                for command in commands(block.text)
                if command.startswith(PROGRAM)
            ]
    return [(page, text) for page, text in pairs if text.split("&&")[0].strip() != "COMMAND"]


@pytest.mark.parametrize(("page", "command"), told())
def test_a_command_has_the_options_that_it_is_told_with(page, command):
    first = command.partition("&&")[0].partition(" #")[0]
    options = command_parser().parse_args(shlex.split(first))
    study = getattr(options, "study", "NAME")
    if not study.isupper() and not study.endswith((".toml", ".json")):
        assert {study, study.replace("-", "_")} & {*known_studies(), "mine"}, page


def run_page(page: str, folder, monkeypatch, marks: set[str]) -> None:
    """Run the blocks of a page with one of the marks, in order, in an empty folder."""
    monkeypatch.chdir(folder)
    mpl.use("Agg")
    names: dict[str, Any] = {"__name__": "page"}
    for block in BLOCKS:
        if block.page == page and block.mark in marks:
            if block.mark == "needs":
                provide(block.value)
            run_block(block, names)
    plt.close("all")


@pytest.mark.parametrize("page", USUAL)
def test_a_page_runs_as_it_is_printed(page, tmp_path, monkeypatch):
    run_page(page, tmp_path, monkeypatch, MARKS - {"not run", "exhaustive"})


@pytest.mark.exhaustive
@pytest.mark.parametrize("page", [page for page in RUN if page not in USUAL])
def test_a_page_runs_as_it_is_printed_however_long(page, tmp_path, monkeypatch):
    run_page(page, tmp_path, monkeypatch, MARKS - {"not run"})


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("bash", "elastomer-friction plan nowhere\n"),
        ("bash", "make nothing-of-this-name\n"),
        ("bash", "cat nothing-of-this-name\n"),
        ("python", "result = nothing_of_this_name\n"),
    ],
)
def test_a_snippet_that_rots_fails(language, text):
    block = Block("page", 1, "", "", language, text)
    with pytest.raises((AssertionError, NameError, subprocess.CalledProcessError)):
        run_block(block, {})
