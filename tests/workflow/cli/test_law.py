"""`law NAME` tells a reduced law of a result, and writes it for others."""

import pytest

from elastomer_friction.workflow.cli.command_line import WRITTEN
from elastomer_friction.workflow.law import read
from elastomer_friction.workflow.law.law_export import FORMS
from elastomer_friction.workflow.result import write_datasets
from tests.support.commands import output, refusal
from tests.workflow.law.given import load_law, memory_law, result

MARKS = {"study": '{"study": {}}', "code": "0", "seed": 1, "source": "synthetic"}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """Return a result file with traces, and a comparison of another law."""
    found = tmp_path_factory.mktemp("law") / "steps.nc"
    groups = {"": memory_law(1), "other": memory_law(0)}
    write_datasets(found, {name: result(law, **MARKS) for name, law in groups.items()})
    return found


def test_the_command_knows_every_form_of_a_law():
    """It names them itself, for a help text that imports no law."""
    assert tuple(FORMS) == WRITTEN


def test_it_is_told_and_written_and_read_again(capsys, path, tmp_path):
    json, header = tmp_path / "new" / "rubber.json", tmp_path / "rubber.h"
    command = ["law", str(path), "--states", "1"]
    text = output(capsys, *command, "--write", "json", "--out", str(json))
    assert text.startswith("kind: states; ")
    assert " rms  segment 3, 0.01 m/s\n" in text
    assert text.endswith(f"{json}: the law as JSON\n")
    told = output(capsys, "law", str(json))
    assert text.startswith(told)
    output(capsys, "law", str(json), "--write", "c", "--out", str(header))
    assert "rubber_step(double *state, double v, double dt)" in header.read_text()
    printed = output(capsys, "law", str(json), "--write", "modelica")
    assert printed.startswith("block rubber ")
    assert read(json).rate.size == 2


def test_of_a_table_over_the_load_one_law_is_told_and_written(capsys, tmp_path):
    json = tmp_path / "table.json"
    json.write_text(load_law().to_json())
    command = ["law", str(json), "--write", "fortran"]
    assert "takes the law of one load" in refusal(capsys, *command)
    assert "--at hurst: is nothing that this law" in refusal(capsys, *command, "--at", "hurst=1")
    text = output(capsys, *command, "--at", "normal_force=2")
    assert "subroutine table_step" in text
    assert "normal force 2 N" in text


def test_a_comparison_and_what_is_held_out(capsys, path):
    asked = ["--group", "other", "--states", "0", "--held-out", str(path)]
    text = output(capsys, "law", str(path), *asked)
    assert "target []" in text
    assert "held out: synthetic\n" in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--out", "x.h"], "--out x.h: says where to write, not what; give --write too"),
        (["--write", "fmu"], "--write fmu: is no text; give a file by --out"),
        (["--group", "none"], "has no such comparison; known are other"),
        (["--at", "hurst"], "--at hurst: must be AXIS=VALUE, as hurst=0.7"),
        (["--at", "hurst=0.7"], "hurst = 0.7: the result has no such point"),
        (["--states", "9"], "states = 9: must be a whole number, 0 to 5"),
        (["--held-out", "none.nc"], "none.nc: not found"),
    ],
)
def test_refusals(capsys, path, arguments, answer):
    assert answer in refusal(capsys, "law", str(path), *arguments)


def test_it_never_writes_over_what_it_reads(capsys, path, tmp_path):
    before = path.read_bytes()
    answer = refusal(capsys, "law", str(path), "--write", "json", "--out", str(path))
    assert answer == f"error: --out {path}: is what the law is made of; name another file\n"
    assert path.read_bytes() == before
    json = tmp_path / "law.json"
    json.write_text(memory_law().to_json())
    assert "is what the law is made of" in refusal(
        capsys, "law", str(json), "--write", "c", "--out", str(json)
    )
    assert "--kind: belongs to a fit, and" in refusal(capsys, "law", str(json), "--kind", "lugre")
    assert "none.json: cannot be read" in refusal(capsys, "law", str(tmp_path / "none.json"))
    assert "not found; first run: " in refusal(capsys, "law", "fig2", "--results", str(tmp_path))
