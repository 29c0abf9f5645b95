"""Files, links and targets of make that the documents name exist."""

import re
import subprocess
from pathlib import Path

import pytest

from elastomer_friction.workflow.study.effects.material import MATERIAL
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from elastomer_friction.workflow.study.effects.scene import SCENE
from elastomer_friction.workflow.study.effects.segment_keys import (
    HOLD,
    OSCILLATE,
    RAMP,
    SEGMENTS,
    SLIDE,
)

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
NAMES = [page.relative_to(ROOT).as_posix() for page in PAGES]
FOLDERS = r"(?:kernels|workflow|studies|tests|docs|\.ci)"
# Paths start at the root of the repository; `NAME`, `<room>` and `*` represent any name, and
# ``mine`` is a study of the reader.
PATH = re.compile(rf"(?<![\w./~-])({FOLDERS}/[\w./*<>-]*[\w*>/])")
LINK = re.compile(r"\]\((?!https?://|mailto:|#)([^)\s#]+)(?:#[^)]*)?\)")
TARGET = re.compile(r"(?:`|^ {4}|\(|^(?=make [\w-]+(?:  |$)))make ([a-z%-][\w%-]*)", re.MULTILINE)


def found(pattern: re.Pattern, page: str) -> set[str]:
    """Return the matches of a pattern on a page."""
    return set(pattern.findall((ROOT / page).read_text(encoding="utf-8")))


@pytest.mark.parametrize("page", NAMES)
def test_every_path_of_ours_is_there(page):
    missing = []
    for path in found(PATH, page):
        pattern = re.sub(r"<\w+>|\bNAME\b|\bfigN\b|(?<=^studies/)mine\b.*", "*", path)
        if not any(ROOT.glob(pattern.rstrip("/"))):
            missing.append(path)
    assert not missing


@pytest.mark.parametrize("page", NAMES)
def test_every_link_leads_somewhere(page):
    folder = (ROOT / page).parent
    assert not [link for link in found(LINK, page) if not (folder / link).exists()]


@pytest.mark.parametrize("page", NAMES)
def test_every_target_of_make_is_there(page):
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    known = set(re.findall(r"^([a-z%-]+):", makefile, re.MULTILINE))
    for target in found(TARGET, page) - known:
        study = target.removeprefix("study-")
        assert (ROOT / "studies" / study / "study.toml").is_file() or study in ("NAME", "mine"), (
            target
        )


def test_the_patterns_find_what_they_are_for():
    assert len(set().union(*(found(PATH, page) for page in NAMES))) > 20
    assert len(set().union(*(found(LINK, page) for page in NAMES))) > 20
    assert {"setup", "test", "check"} <= set().union(*(found(TARGET, page) for page in NAMES))


def test_every_key_of_a_scene_is_described():
    page = (ROOT / "docs" / "scenes.md").read_text(encoding="utf-8")
    page += (ROOT / "docs" / "reference" / "keys.md").read_text(encoding="utf-8")
    segments = {**SLIDE, **HOLD, **RAMP, **OSCILLATE}
    for key in (*MATERIAL, *SCENE, *SEGMENTS, *segments, *QUANTITIES, "record", "trace"):
        assert re.search(rf"`{key}|^### [\w.]+\.{key}$", page, re.MULTILINE), key


@pytest.mark.parametrize(
    ("target", "study"),
    [(["study-mine"], "mine"), (["study", "STUDY=a/b.toml"], "a/b.toml")],
    ids=["by its name", "by its path"],
)
def test_a_study_is_run_and_then_drawn(target, study):
    done = subprocess.run(
        ["make", "-n", *target, "SCALE=smoke"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    lines = [line for line in done.stdout.splitlines() if " -m workflow " in line]
    commands = [line.partition(" -m workflow ")[2] for line in lines]
    assert commands == [f"run {study} --scale smoke ", f"figure {study} --scale smoke "]
