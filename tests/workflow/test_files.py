"""Files that are damaged, foreign, of other settings, on a full or a read-only disk.

Each is answered with one line and exit status 2; nothing that was there is lost or overwritten.
"""

import contextlib
import shutil
import subprocess

import netCDF4
import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt

from tests.workflow.small import write_study
from tests.workflow.synthetic import result, with_alpha
from workflow.cli import main
from workflow.result.netcdf import write_datasets

FIGURE = """
import xarray as xr
from matplotlib.figure import Figure


def draw(groups):
    figure = Figure()
    figure.subplots().plot(groups[""].mu_1.values.ravel())
    return figure
"""
OLD_FORM = """
def draw(result):
    raise AssertionError("is not called")
"""
READERS = ("figure", "table")
OLD = b"what was there before"


@pytest.fixture
def place(tmp_path, finished):
    """Return a folder with the small study, its figure script and its finished result."""
    write_study(tmp_path)
    (tmp_path / "figure.py").write_text(FIGURE)
    shutil.copy(finished.path, tmp_path / "small.nc")
    return tmp_path


def call(capsys, command, folder, *more):
    """Run a command on the small study; return (exit status, stdout, stderr)."""
    status = main([command, str(folder / "small.toml"), "--out", str(folder), *more])
    plt.close("all")
    return (status, *capsys.readouterr())


def contents(folder):
    """Return name -> bytes of all files of a folder but its store."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def assert_refused(capsys, command, folder, *more):
    """Assert exit status 2, one line, and that no file has changed; return the line."""
    before = contents(folder)
    status, out, err = call(capsys, command, folder, *more)
    assert (status, out) == (2, "")
    assert err.startswith("error: ")
    assert err.count("\n") == 1
    assert contents(folder) == before
    return err


def cut(share):
    """Return how to cut a file."""
    return lambda content: content[: int(share * len(content))]


def foreign(_):
    """Return a netCDF file of another program."""
    data = netCDF4.Dataset("foreign.nc", "w", memory=1024)
    data.createDimension("x", 3)
    return bytes(data.close())


DAMAGE = {
    "empty": cut(0.0),
    "a tenth": cut(0.1),
    "half": cut(0.5),
    "all but the last bytes": lambda content: content[:-100],
    "zeros": lambda content: bytes(len(content)),
    "text": lambda _: b"not netCDF at all\n",
    "of another program": foreign,
}


@pytest.mark.parametrize("name", DAMAGE)
@pytest.mark.parametrize("command", READERS)
def test_a_result_that_is_none_is_refused(capsys, place, command, name):
    path = place / "small.nc"
    path.write_bytes(DAMAGE[name](path.read_bytes()))
    for kind in ("png", "pdf", "csv"):
        (place / f"small.{kind}").write_bytes(OLD)
    message = assert_refused(capsys, command, place)
    assert "small.nc: cannot be read as netCDF" in message or "is not a result" in message


@pytest.mark.parametrize("command", READERS)
def test_no_result_and_a_folder_in_its_place_are_refused(capsys, place, command):
    (place / "small.nc").unlink()
    assert "small.nc: not found; first run: python -m" in assert_refused(capsys, command, place)
    (place / "small.nc").mkdir()
    assert "not found" in assert_refused(capsys, command, place)


def test_a_flipped_bit_in_a_variable_is_noticed(capsys, place):
    path = place / "small.nc"
    with xr.open_dataset(path) as dataset:
        number = dataset.mu_1.values.ravel()[1].tobytes()
    content = path.read_bytes()
    at = content.index(number)
    path.write_bytes(content[:at] + bytes([content[at] ^ 1]) + content[at + 1 :])
    for command in READERS:
        assert "small.nc: cannot be used by small" in assert_refused(capsys, command, place)


def rewritten(place, change):
    """Write the result again as ``change`` makes it."""
    with xr.open_dataset(place / "small.nc") as dataset:
        changed = change(dataset.load())
    write_datasets(place / "small.nc", {"": changed})


def test_a_result_without_an_axis_is_refused(capsys, place):
    rewritten(place, lambda dataset: dataset.isel(velocity=0, drop=True))
    for command in READERS:
        assert "it has no axis velocity" in assert_refused(capsys, command, place)


def test_a_result_of_an_older_program_without_a_variable_says_so(capsys, place):
    rewritten(place, lambda dataset: dataset.drop_vars("mu_1").assign_attrs(code="0123"))
    before = contents(place)
    status, out, err = call(capsys, "figure", place)
    assert (status, out) == (2, "")
    note, message = err.splitlines()
    assert note.endswith("small.nc: was computed by another version of the program")
    assert "small.nc: cannot be used by small" in message
    assert "mu_1" in message
    assert contents(place) == before


@pytest.mark.parametrize("command", READERS)
def test_a_result_of_other_settings_is_said_or_refused(capsys, place, command):
    _, _, err = call(capsys, command, place)
    assert err == ""
    asked = ("--set", "grid.hurst=0.5", "--set", "study.seed=2")
    message = assert_refused(capsys, command, place, *asked)
    assert "was computed with other settings than asked for: grid.hurst, study.seed;" in message
    text = (place / "small.toml").read_text()
    (place / "small.toml").write_text(text.replace("hurst = [0.3, 0.7]", "hurst = 0.5"))
    status, out, err = call(capsys, command, place)
    assert status == 0
    assert out
    assert err.startswith("note: ")
    assert err.endswith("other settings than asked for: grid.hurst; shown is the file\n")


@pytest.mark.parametrize("command", READERS)
def test_where_it_is_computed_is_no_difference(capsys, place, command):
    status, _, err = call(capsys, command, place, "--set", "cluster.jobs=3")
    assert (status, err) == (0, "")


def test_the_report_names_the_file_it_cannot_read(capsys, tmp_path):
    dataset = result("fig8", hurst=[0.0, 0.5, 1.0])
    write_datasets(tmp_path / "fig8.nc", {"": with_alpha(dataset, 1.0 - dataset.hurst)})
    content = (tmp_path / "fig8.nc").read_bytes()
    (tmp_path / "report.html").write_bytes(OLD)
    for damage in DAMAGE.values():
        (tmp_path / "fig8.nc").write_bytes(damage(content))
        assert main(["report", "--out", str(tmp_path)]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert "fig8.nc: " in err
        assert err.count("\n") == 1
        assert (tmp_path / "report.html").read_bytes() == OLD


def test_the_report_says_which_settings_differ(tmp_path, capsys):
    dataset = result("fig8", hurst=[0.0, 0.5, 1.0])
    text = dataset.attrs["study"].replace('"seed": ', '"seed": 1')
    dataset = with_alpha(dataset, 1.0 - dataset.hurst).assign_attrs(study=text)
    write_datasets(tmp_path / "fig8.nc", {"": dataset})
    assert main(["report", "--out", str(tmp_path)]) == 0
    plt.close("all")
    assert "Not as in study.toml" in (tmp_path / "report.html").read_text(encoding="utf-8")
    capsys.readouterr()


@contextlib.contextmanager
def mounted(folder, *options):
    """Mount a small disk on the folder, or skip where that is not permitted."""
    folder.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip(f"a disk cannot be mounted here: {done.stderr.strip()}")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def fill(disk):
    """Write until nothing more fits."""
    with (disk / "filler").open("wb", buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(4096))


@pytest.mark.parametrize("command", READERS)
def test_a_full_disk_is_one_line_and_what_was_there_stays(capsys, place, tmp_path, command):
    with mounted(tmp_path / "disk", "size=2m") as disk:
        for name in ("small.nc", "small.toml", "figure.py"):
            shutil.copy(place / name, disk)
        for kind in ("png", "pdf", "csv"):
            (disk / f"small.{kind}").write_bytes(OLD)
        fill(disk)
        assert "cannot be written: No space left" in assert_refused(capsys, command, disk)


def test_a_figure_script_of_the_old_form_is_told_what_to_change(capsys, place):
    (place / "figure.py").write_text(OLD_FORM)
    said = assert_refused(capsys, "figure", place)
    assert f"{place}/figure.py: draw takes the path of a result; write draw(groups)" in said
    assert 'groups[""] is the study' in said


@pytest.mark.parametrize("command", [*READERS, "run"])
def test_a_read_only_disk_is_one_line(capsys, place, tmp_path, scheduler, command):
    with mounted(tmp_path / "disk", "size=4m") as disk:
        for name in ("small.nc", "small.toml", "figure.py"):
            shutil.copy(place / name, disk)
        subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
        more = ("--scheduler", scheduler) if command == "run" else ()
        assert "Read-only file system" in assert_refused(capsys, command, disk, *more)
        for reading in ("status", "plan"):
            assert call(capsys, reading, disk)[0] == 0


def test_a_run_on_a_full_disk_keeps_the_old_result(capsys, place, tmp_path, scheduler):
    with mounted(tmp_path / "disk", "size=1m") as disk:
        shutil.copy(place / "small.toml", disk)
        (disk / "small.nc").write_bytes(OLD)
        fill(disk)
        status = main(
            ["run", str(disk / "small.toml"), "--out", str(disk), "--scheduler", scheduler]
        )
        err = capsys.readouterr().err
        assert status == 2
        assert "No space left" in err
        assert "Traceback" not in err
        assert (disk / "small.nc").read_bytes() == OLD


def test_a_result_written_and_read_again_is_the_same(place):
    with xr.open_dataset(place / "small.nc") as dataset:
        before = dataset.load()
    rewritten(place, lambda dataset: dataset)
    with xr.open_dataset(place / "small.nc") as dataset:
        for name, variable in dataset.variables.items():
            assert np.array_equal(variable.values, before[name].values, equal_nan=True)
