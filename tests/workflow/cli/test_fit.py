"""`fit FILE…` says what measured steps determine, and draws it."""

import pytest

from tests.support.commands import output, refusal
from tests.workflow.laboratory.given import record, records, write


def test_a_file_of_one_step(capsys, tmp_path):
    path = write(tmp_path / "one.txt", record())
    text = output(capsys, "fit", str(path), "--out", str(tmp_path / "new" / "fit.png"))
    assert text.startswith("one.txt: from 0.1 to 0.12 m/s\n")
    assert "not determined          tau, H and q_max: one speed" in text
    assert text.endswith(f"{tmp_path}/new/fit.png\n{tmp_path}/new/fit.pdf\n")
    assert (tmp_path / "new" / "fit.pdf").stat().st_size > 1000


def test_several_files_and_what_is_known(capsys, tmp_path):
    paths = [str(write(tmp_path / f"{i}.txt", one)) for i, one in enumerate(records([0.05, 0.3]))]
    out = ["--out", str(tmp_path / "f.png"), "--relaxation-time", "0.1"]
    text = output(capsys, "fit", *paths, *out)
    assert "  tau                     0.1 s, given\n" in text
    assert "  q_max " in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--columns", "0,1"], "--columns 0,1: must be three numbers from 0, as 0,1,2"),
        (["--window", "-1"], "--window -1: must be greater than zero"),
        (["--q-max", "nan"], "--q-max nan: must be greater than zero"),
        (["--hurst", "1.5"], "--hurst 1.5: must lie between 0 and 1"),
        (["--columns", "0,1,7"], "one.txt': holds no row of 3 numbers in columns [0, 1, 7]"),
    ],
)
def test_refusals(capsys, tmp_path, arguments, answer):
    path = write(tmp_path / "one.txt", record())
    assert answer in refusal(capsys, "fit", str(path), *arguments)
