"""Try again all that docs/reliability.md says was tried; print what held and what broke.

    python -m tests.tools.trials            a quarter of an hour on two cores
    python -m tests.tools.trials disk       the rows alone that hold a word

The page is the list: the last column of its tables names the files of tests of a row, which broke
where any test of a file did.
"""

import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections import Counter
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "reliability.md"
TEST_FILE = re.compile(r"`(tests/[\w/]+/test_\w+\.py)`")
WIDTH = 90  # letters of a trial that are printed


class Trial(NamedTuple):
    """A row of the page: what was tried, and the files of the tests that try it."""

    what: str
    files: tuple[str, ...]


def trials(text: str) -> list[Trial]:
    """Return the rows of all tables of a page."""
    rows = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    rows = [row for row in rows if row[0].strip() != "what was tried"]
    return [Trial(row[0].strip(), tuple(TEST_FILE.findall(row[-1]))) for row in rows]


def outcomes(files: list[str]) -> dict[str, Counter[str]]:
    """Run tests, those with clusters too; return by file how many held, broke, were skipped."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        words = ["-q", "-m", "not exhaustive", f"--junitxml={report}", "-o", "junit_family=xunit1"]
        subprocess.run([sys.executable, "-m", "pytest", *words, *files], cwd=ROOT, check=False)
        cases = ET.parse(report).getroot().iter("testcase")
        found = {file: Counter[str]() for file in files}
        for case in cases:
            kinds = {child.tag for child in case}
            broke, skipped = kinds & {"failure", "error"}, "skipped" in kinds
            found[case.get("file", "")]["broke" if broke else "skipped" if skipped else "held"] += 1
        return found


def verdict(trial: Trial, found: dict[str, Counter[str]]) -> str:
    """Return what became of a trial, in one word or two."""
    if not trial.files:
        return "by hand"
    total = sum((found[file] for file in trial.files), Counter[str]())
    if total["broke"] or not total:
        return "BROKE"
    return "held" if total["held"] else "skipped"


def main(words: list[str]) -> int:
    """Print the table; return 1 where something broke."""
    rows = [t for t in trials(PAGE.read_text()) if all(w in t.what.lower() for w in words)]
    files = sorted({file for row in rows for file in row.files})
    found = outcomes(files) if files else {}
    verdicts = [verdict(row, found) for row in rows]
    for row, said in zip(rows, verdicts, strict=True):
        print(f"{said:8} {row.what[:WIDTH]}")
    print(", ".join(f"{number} {said}" for said, number in Counter(verdicts).items()))
    return int("BROKE" in verdicts)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
