"""What is named as a file and is none is refused at once, and so is one beyond a stated size."""

import os
import re
import signal

import pytest

from elastomer_friction.workflow.ground import MAX_INPUT_BYTES, UserError
from elastomer_friction.workflow.study.read import known_studies, read_study
from tests.support.commands import output, refusal
from tests.support.documents import without
from tests.support.small import TEXT, write_study


@pytest.fixture(autouse=True)
def at_once():
    """Let nothing wait for whoever writes into a pipe."""

    def give_up(*_):
        raise AssertionError("it waits")

    signal.signal(signal.SIGALRM, give_up)
    signal.alarm(60)
    yield
    signal.alarm(0)


def pipe(path):
    os.mkfifo(path)
    return "it is not a regular file"


def device(path):
    path.symlink_to("/dev/zero")
    return "it is not a regular file"


def vast(path):
    with path.open("wb") as file:
        file.truncate(MAX_INPUT_BYTES + 1)  # it takes no room
    return f"it has {MAX_INPUT_BYTES + 1} bytes, more than {MAX_INPUT_BYTES}"


SPECIAL = pytest.mark.parametrize("make", [pipe, device, vast])
NAMED = {
    "a line as text": 'surface.file="special.csv"',
    "a line of another program": 'surface.file="special.x3p"',
    "an array": 'surface.file="special.npy"',
    "netCDF": 'surface.file="special.nc"',
    "branches": 'material.branches_file="special.csv"',
    "shifts": 'material.shifts_file="special.csv"',
    "a programme": 'scene.programme=[{file="special.csv"}]',
}


@pytest.mark.parametrize(
    ("setting", "make"),
    [
        pytest.param(setting, make, id=f"{name}, {make.__name__}")
        for name, setting in NAMED.items()
        for make in (pipe, device, vast)
        if make is not vast or name not in ("an array", "netCDF")  # no more is read than is used
    ],
)
def test_a_special_file_that_a_study_names_is_refused(tmp_path, make, setting):
    study = write_study(tmp_path, without("surface.length") if "surface" in setting else TEXT)
    why = make(tmp_path / re.search(r"special\.\w+", setting)[0])
    with pytest.raises(UserError) as error:
        read_study(study, None, [setting])
    assert f"cannot be read: {why}" in str(error.value)


@SPECIAL
@pytest.mark.parametrize("command", ["prony", "fit"])
def test_a_special_file_of_measurements_is_refused(tmp_path, capsys, make, command):
    why = make(tmp_path / "special.csv")
    assert f"cannot be read: {why}" in refusal(capsys, command, str(tmp_path / "special.csv"))


@SPECIAL
def test_a_special_study_is_refused_and_those_beside_it_are_listed(
    tmp_path, capsys, monkeypatch, make
):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "studies" / "special"
    folder.mkdir(parents=True)
    make(folder / "study.toml")
    assert "special" in known_studies()
    assert "cannot be read as TOML: it " in refusal(capsys, "plan", "special")
    assert re.search(r"special +\(its study.toml cannot be read\)", output(capsys, "studies"))
