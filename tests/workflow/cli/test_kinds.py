"""What the commands do with each kind of study."""

import re

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.cli.commands import KINDS
from elastomer_friction.workflow.study.study import AnyStudy
from tests.support.commands import facts, output, refusal


def test_status_before_a_run(capsys, study, tmp_path):
    found = facts(output(capsys, "status", study, "--out", str(tmp_path / "out")))
    assert found["done"] == "done        0 of 64 records (problem x block)"
    assert "core-hours, predicted" in found["remaining"]
    assert found["run"] == "run         not running"
    assert found["result"].endswith("small.nc (not written yet)")
    assert not (tmp_path / "out").exists()


def test_status_after_a_run(capsys, study, finished):
    found = facts(output(capsys, "status", study, "--out", str(finished.path)))
    assert found["done"].startswith("done        64 of 64 records")
    assert found["failed"] == "failed      0 problems"
    assert found["remaining"].startswith("remaining   0 core-hours")
    assert found["run"].startswith("run         finished, 20")
    assert found["result"] == f"result      {finished.path}"


def test_a_measured_study_is_planned_run_and_shown_by_the_same_commands(capsys, powers):
    results = powers.parents[1] / "results"
    planned = output(capsys, "plan", "powers")
    assert "powers: Powers of two\n" in planned
    assert "powers      3\n" in planned
    assert re.search(r"^predicted   about [\d.]+ to [\d.]+ core-seconds$", planned, re.MULTILINE)
    assert "not written yet" in output(capsys, "status", "powers")
    for command in ("figure", "table"):
        assert "powers.nc: not found" in refusal(capsys, command, "powers")
    assert main(["run", "powers"]) == 0
    out, err = capsys.readouterr()
    assert (out.splitlines()[0], out.splitlines()[-1]) == ("largest 4", "results/powers.nc")
    assert "measuring: 100%" in err
    assert "not written yet" not in output(capsys, "status", "powers")
    drawn = output(capsys, "figure", "powers").split()
    assert drawn == ["results/powers.png", "results/powers.pdf"]
    output(capsys, "table", "powers")
    assert (results / "powers.csv").read_text() == "found\n1\n2\n4\n"


def test_every_kind_of_study_can_be_told_every_command():
    kinds = {kind.kind for kind in AnyStudy.__subclasses__()}
    assert kinds == set(KINDS)
    assert all(callable(command) for kind in KINDS.values() for command in kind.values())
