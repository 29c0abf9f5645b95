"""Provenance: sufficient to repeat a run, and the same in each run."""

import json
import re
import subprocess

import pytest

from elastomer_friction.workflow.result.provenance import commit, maker_attributes, provenance
from elastomer_friction.workflow.simulate.code_hash import CODE_HASH
from elastomer_friction.workflow.study.read import read_study
from elastomer_friction.workflow.system.packages import Maker, package_versions, this_maker
from tests.support.small import small_study, write_study

STUDY = small_study("study.seed=7", "scene.indentation_rate=false", scale="wide")
ATTRIBUTES = provenance(STUDY, STUDY.variants[""])


def test_settings_in_force_make_the_same_study_again(tmp_path):
    tables = json.loads(ATTRIBUTES["study"])
    del tables["compare"]
    settings = [f"{t}.{key}={json.dumps(tables[t][key])}" for t in tables for key in tables[t]]
    again = read_study(write_study(tmp_path, ""), settings=settings)
    assert (again.grid, again.seed, again.scene) == (STUDY.grid, 7, STUDY.scene)
    assert again.variants[""] == STUDY.variants[""]


def test_settings_and_environment_are_separate_attributes():
    expected = {
        "seed": 7,
        "scheme": "exponential",
        "steps_per_spacing": "auto",
        "horizon": 4.0,
        "quantities": "steady jump relaxation",
        "indentation_rate": "false",
        "realizations_per_block": 4,
        "title": "small",
        "code": CODE_HASH,
        "written_with": package_versions(),
        "versions": this_maker().versions,
        "processor": this_maker().processor,
    }
    assert expected.items() <= ATTRIBUTES.items()
    assert "doi:10.1038/srep05795" in ATTRIBUTES["references"]
    coarse = provenance(STUDY, STUDY.variants["coarse"])
    assert (coarse["scheme"], coarse["steps_per_spacing"]) == ("implicit-euler", "1")


def test_commit_is_a_full_hash_or_unknown(monkeypatch):
    monkeypatch.delenv("GIT_DIR", raising=False)
    assert re.fullmatch(r"[0-9a-f]{40}(-dirty)?|.+-g[0-9a-f]{40}(-dirty)?|unknown", commit())


def git(folder, *command):
    """Run git in a folder under a test identity."""
    identity = ("-c", "user.name=a", "-c", "user.email=a@b")
    subprocess.run(["git", "-C", str(folder), *identity, *command], check=True, capture_output=True)


def test_commit_is_not_that_of_a_repository_that_the_program_lies_in(tmp_path, monkeypatch):
    monkeypatch.delenv("GIT_DIR", raising=False)
    program = tmp_path / "project" / "lib" / "packages"
    file = program / "workflow" / "result" / "provenance.py"
    file.parent.mkdir(parents=True)
    file.write_text("")
    git(tmp_path, "init", "project")
    git(tmp_path / "project", "add", ".")
    git(tmp_path / "project", "commit", "-m", "somebody's")
    assert commit(program) == "unknown"  # an environment within a project
    git(program, "init", ".")
    git(program, "commit", "--allow-empty", "-m", "somebody's, too")
    assert commit(program) == "unknown"  # packages installed at the top of a project
    git(program, "add", ".")
    git(program, "commit", "-m", "ours")
    assert re.fullmatch(r"[0-9a-f]{40}", commit(program))
    file.write_text("edited")
    assert re.fullmatch(r"[0-9a-f]{40}-dirty", commit(program))


def test_several_makers_of_the_records_are_listed_as_mixed():
    one, other = Maker("numpy 2.0", "a processor"), Maker("numpy 2.1", "a processor")
    assert maker_attributes({one}) == {"versions": "numpy 2.0", "processor": "a processor"}
    both = maker_attributes({other, one})
    assert both == {"versions": "mixed: numpy 2.0 | numpy 2.1", "processor": "a processor"}
    assert maker_attributes({one, Maker("numpy 2.0", "another")})["processor"].startswith(
        "mixed: a proc"
    )


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
    assert {**again, "commit": ATTRIBUTES["commit"]} == ATTRIBUTES
    assert not {"date", "host", "user", "folder"} & set(ATTRIBUTES)
