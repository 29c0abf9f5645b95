"""Where a result comes from: enough to make it again, nothing that changes between runs."""

import json
import re
import subprocess

import pytest

from tests.support.small import small_study, write_study
from workflow.result.provenance import commit, provenance
from workflow.simulate.code import CODE
from workflow.study.read import read_study
from workflow.system.packages import package_versions, processor

STUDY = small_study("study.seed=7", "scene.indentation_rate=false", scale="wide")
FOUND = provenance(STUDY, STUDY.variants[""])


def test_settings_in_force_make_the_same_study_again(tmp_path):
    tables = json.loads(FOUND["study"])
    del tables["compare"]
    said = [f"{t}.{key}={json.dumps(tables[t][key])}" for t in tables for key in tables[t]]
    again = read_study(write_study(tmp_path, ""), settings=said)
    assert (again.grid, again.seed, again.scene) == (STUDY.grid, 7, STUDY.scene)
    assert again.variants[""] == STUDY.variants[""]


def test_settings_and_surroundings_are_attributes_of_their_own_too():
    expected = {
        "seed": 7,
        "scheme": "exponential",
        "steps_per_spacing": "auto",
        "horizon": 4.0,
        "quantities": "steady jump relaxation",
        "indentation_rate": "false",
        "realizations_per_block": 1,
        "title": "small",
        "code": CODE,
        "versions": package_versions(),
        "processor": processor(),
    }
    assert expected.items() <= FOUND.items()
    assert "doi:10.1038/srep05795" in FOUND["references"]
    coarse = provenance(STUDY, STUDY.variants["coarse"])
    assert (coarse["scheme"], coarse["steps_per_spacing"]) == ("implicit-euler", "1")


def test_commit_is_a_full_hash_or_unknown(monkeypatch):
    monkeypatch.delenv("GIT_DIR", raising=False)
    assert re.fullmatch(r"[0-9a-f]{40}(-dirty)?|.+-g[0-9a-f]{40}(-dirty)?|unknown", commit())


@pytest.mark.parametrize(
    "error", [FileNotFoundError("git"), subprocess.CalledProcessError(128, "git")]
)
def test_commit_is_unknown_without_git_or_repository(monkeypatch, error):
    def fail(*_, **__):
        raise error

    monkeypatch.setattr(subprocess, "run", fail)
    assert commit() == "unknown"


def test_nothing_depends_on_when_or_where():
    again = provenance(STUDY, STUDY.variants[""])
    assert {**again, "commit": FOUND["commit"]} == FOUND
    assert not {"date", "history", "host", "user", "folder"} & set(FOUND)
