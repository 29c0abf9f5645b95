"""The fenced blocks of the documents: what they hold, and how they are run as they are printed.

An HTML comment on the line before a block says what is special about it:

    <!-- file: PATH -->         it is the file PATH, from the working folder
    <!-- needs: STUDY -->       it opens results/STUDY.nc, which is computed before, if roughly
    <!-- exhaustive -->         it takes long: make test-all runs it
    <!-- not run: REASON -->    it is read, but not run
"""

import re
import shlex
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

from elastomer_friction.workflow.cli import main

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
BLOCK = re.compile(
    r"^(?:<!-- (?P<mark>[^>]*) -->\n)?```(?P<language>\w*)\n(?P<text>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
PROGRAM = "elastomer-friction "
ROUGHLY = {"fig7": ("--scale", "smoke", "--set", "study.realizations=8")}  # of what is needed


class Block(NamedTuple):
    """One fenced block of a page."""

    page: str
    line: int
    mark: str  # file, needs, exhaustive, not run; empty: it is run as it is
    value: str  # what the mark says after its colon
    language: str
    text: str

    def __str__(self) -> str:
        """Name the block."""
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
    """Return the commands of a block of shell, one line each, without comments."""
    lines = text.replace("\\\n", " ").splitlines()
    stripped = (re.sub(r"\s+#.*$", "", line).strip() for line in lines)
    return [line for line in stripped if line and not line.startswith("#")]


def run_block(block: Block, names: dict[str, Any]) -> None:
    """Run a block in the working folder; ``names`` are those of Python on its page."""
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
    """Compute results/STUDY.nc, if roughly, where it is not there."""
    result = Path("results") / f"{study}.nc"
    if not result.is_file():
        assert main(["run", study, "--out", str(result), *ROUGHLY[study]]) == 0


def _run(command: str) -> None:
    if command.startswith(PROGRAM):
        assert main(shlex.split(command.removeprefix(PROGRAM))) == 0, command
    elif command.startswith("make "):  # said what it would do, as it needs an environment
        subprocess.run(["make", "-n", *shlex.split(command)[1:]], cwd=ROOT, check=True)
    else:
        subprocess.run(["bash", "-ec", command], check=True)
