"""Targets of make that take a study: what they would run."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]


@pytest.mark.parametrize(
    ("target", "study"),
    [(["study-mine"], "mine"), (["study", "STUDY=a/b.toml"], "a/b.toml")],
    ids=["by its name", "by its path"],
)
def test_a_study_is_run_and_then_drawn(target, study):
    told = subprocess.run(
        ["make", "-n", *target, "SCALE=smoke"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    lines = [line for line in told.stdout.splitlines() if " -m workflow " in line]
    commands = [line.partition(" -m workflow ")[2] for line in lines]
    assert commands == [f"run {study} --scale smoke ", f"figure {study} --scale smoke "]
