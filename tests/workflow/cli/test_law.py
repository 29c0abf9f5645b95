"""The command `law` describes a reduced law of a result, and exports it."""

import pytest

from elastomer_friction.workflow.cli.command_line import LAW_FORMATS
from elastomer_friction.workflow.law import read
from elastomer_friction.workflow.law.law_export import FORMS
from elastomer_friction.workflow.result import write_datasets
from tests.support.commands import output, refusal
from tests.workflow.law.given import load_law, memory_law, result

MARKS = {"study": '{"study": {}}', "code": "0", "seed": 1, "source": "synthetic"}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """Return a result file with traces, and a comparison with traces of another law."""
    path = tmp_path_factory.mktemp("law") / "steps.nc"
    groups = {"": memory_law(1), "other": memory_law(0)}
    write_datasets(path, {name: result(law, **MARKS) for name, law in groups.items()})
    return path


def test_the_help_names_every_form_of_a_law():
    """The command line repeats the names, to print its help without importing `law`."""
    assert FORMS == LAW_FORMATS


def test_a_law_is_described_written_and_read_back(capsys, path, tmp_path):
    json, header = tmp_path / "new" / "rubber.json", tmp_path / "rubber.h"
    command = ["law", str(path), "--states", "1"]
    text = output(capsys, *command, "--write", "json", "--out", str(json))
    assert text.startswith("kind: states; ")
    described, last, _ = text.rpartition(f"{json}: the law as JSON\n")
    told = output(capsys, "law", str(json))
    assert last
    assert told.startswith(described)
    assert " rms  segment 3, 0.01 m/s\n" in told
    output(capsys, "law", str(json), "--write", "c", "--out", str(header))
    assert "rubber_step(double *state, double v, double dt)" in header.read_text()
    printed = output(capsys, "law", str(json), "--write", "fortran")
    assert "module rubber_law" in printed
    assert read(json).rate.size == 2


def test_one_law_of_a_table_over_the_load_is_described_and_written(capsys, tmp_path):
    json = tmp_path / "table.json"
    json.write_text(load_law().to_json())
    command = ["law", str(json), "--write", "fortran"]
    assert "requires the law of one load" in refusal(capsys, *command)
    refused = refusal(capsys, *command, "--at", "hurst=1")
    assert "--at hurst: must be an axis of this law: temperature, normal_force" in refused
    text = output(capsys, *command, "--at", "normal_force=2")
    assert "subroutine table_step" in text
    assert "normal force 2 N" in text


def test_a_law_of_a_comparison_with_a_held_out_result(capsys, path):
    options = ["--group", "other", "--states", "0", "--held-out", str(path)]
    text = output(capsys, "law", str(path), *options)
    assert "target []" in text
    assert "held out: synthetic\n" in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--out", "x.h"], "--out x.h: requires a form; add --write"),
        (["--write", "fmu"], "--write fmu: is a binary file; give its path by --out"),
        (["--write", "pascal"], "argument --write: invalid choice: 'pascal'"),
        (["--group", "none"], "--group none: is not a comparison in"),
        (["--at", "hurst"], "--at hurst: must be AXIS=VALUE, for example hurst=0.7"),
        (["--at", "hurst=0.7"], "hurst = 0.7: the result has no such point"),
        (["--states", "9"], "states = 9: must be a whole number, 0 to 5"),
        (["--held-out", "none.nc"], "none.nc: not found"),
    ],
)
def test_refusals(capsys, path, arguments, answer):
    assert answer in refusal(capsys, "law", str(path), *arguments)


def test_the_input_is_never_overwritten(capsys, path, tmp_path):
    before = path.read_bytes()
    answer = refusal(capsys, "law", str(path), "--write", "json", "--out", str(path))
    assert answer == f"error: --out {path}: is the input of the law; choose another file\n"
    assert path.read_bytes() == before
    json = tmp_path / "law.json"
    json.write_text(memory_law().to_json())
    assert "is the input of the law" in refusal(
        capsys, "law", str(json), "--write", "c", "--out", str(json)
    )
    assert "--kind: applies to a fit, but" in refusal(capsys, "law", str(json), "--kind", "lugre")
    assert "none.json: cannot be read" in refusal(capsys, "law", str(tmp_path / "none.json"))
    assert "not found; first run: " in refusal(capsys, "law", "fig2", "--results", str(tmp_path))
