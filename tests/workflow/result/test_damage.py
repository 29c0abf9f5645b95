"""Results that are damaged, foreign, of an older program or of other settings.

Each is refused in one line with exit status 2; no existing file is lost or overwritten.
"""

import netCDF4
import pytest
import xarray as xr

from elastomer_friction.workflow.result.netcdf import write_datasets
from tests.support.commands import refusal
from tests.support.faults import DAMAGE, endless, flipped
from tests.support.results import OLD, READERS, WRITTEN, assert_refused, call, contents, rewritten
from tests.support.synthetic import result


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_a_file_that_is_not_a_result_is_refused(capsys, shown, damage):
    path = shown / "small.nc"
    path.write_bytes(damage(path.read_bytes()))
    for kind in WRITTEN:
        (shown / f"small.{kind}").write_bytes(OLD)
    for command in READERS:
        message = assert_refused(capsys, command, shown)
        assert "small.nc: cannot be read as netCDF" in message or "is not a result" in message


def test_no_result_and_a_folder_in_its_place_are_refused(capsys, shown):
    (shown / "small.nc").unlink()
    for command in READERS:
        assert "small.nc: not found; first run: python -m" in assert_refused(capsys, command, shown)
    (shown / "small.nc").mkdir()
    assert "not found" in assert_refused(capsys, "table", shown)


def test_a_flipped_bit_in_a_variable_is_noticed(capsys, shown):
    path = shown / "small.nc"
    with xr.open_dataset(path) as dataset:
        number = dataset.mu_1.values.ravel()[1].tobytes()
    content = path.read_bytes()
    path.write_bytes(flipped(content, content.index(number)))
    for command in READERS:
        assert "small.nc: cannot be read as netCDF: " in assert_refused(capsys, command, shown)


def test_a_result_that_promises_more_than_memory_holds_is_refused(capsys, shown):
    """The file is small because chunks that were never written take no space."""
    (shown / "small.nc").rename(shown / "sound.nc")
    with (
        netCDF4.Dataset(shown / "sound.nc") as sound,
        netCDF4.Dataset(shown / "small.nc", "w") as vast,
    ):
        vast.setncatts(sound.__dict__)
        for name in sound.dimensions:
            vast.createDimension(name, 200)
        for name, variable in sound.variables.items():
            chunks = [1] * variable.ndim or None
            vast.createVariable(name, variable.dtype, variable.dimensions, chunksizes=chunks)
    (shown / "sound.nc").unlink()
    for command in READERS:
        assert "small.nc: cannot be read as netCDF: " in assert_refused(capsys, command, shown)


def test_a_forged_result_whose_reading_does_not_end_is_refused(capsys, shown):
    path = shown / "small.nc"
    path.write_bytes(endless(path.read_bytes()))
    for command in READERS:
        assert "cannot be read as netCDF: reading it does not end" in assert_refused(
            capsys, command, shown
        )


def test_a_result_without_an_axis_is_refused(capsys, shown):
    rewritten(shown, lambda dataset: dataset.isel(velocity=0, drop=True))
    for command in READERS:
        assert "it lacks axis velocity" in assert_refused(capsys, command, shown)


def test_a_result_of_an_older_program_without_a_variable_is_refused(capsys, shown):
    rewritten(shown, lambda dataset: dataset.drop_vars("mu_1").assign_attrs(code="0123"))
    before = contents(shown)
    status, out, err = call(capsys, "figure", shown)
    assert (status, out) == (2, "")
    note, message = err.splitlines()
    assert note.endswith("small.nc: was computed by another version of the program")
    assert "small.nc: cannot be used by small" in message
    assert "mu_1" in message
    assert contents(shown) == before


def test_a_result_of_other_settings_is_noted_or_refused(capsys, shown):
    options = ("--set", "grid.hurst=0.5", "--set", "study.seed=2")
    for command in READERS:
        message = assert_refused(capsys, command, shown, *options)
        assert "computed with other settings than requested: grid.hurst, study.seed;" in message
    elsewhere = ("--set", "cluster.jobs=3")  # the place of computation does not matter
    assert call(capsys, "table", shown, *elsewhere)[::2] == (0, "")
    text = (shown / "small.toml").read_text()
    (shown / "small.toml").write_text(text.replace("hurst = [0.3, 0.7]", "hurst = 0.5"))
    status, out, err = call(capsys, "table", shown)
    assert status == 0
    assert out
    assert err.startswith("note: ")
    assert err.endswith("other settings than requested: grid.hurst; the figure shows the file\n")


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_the_report_names_the_file_it_cannot_read(capsys, tmp_path, damage):
    write_datasets(tmp_path / "fig8.nc", {"": result("fig8")})
    path, page = tmp_path / "fig8.nc", tmp_path / "report.html"
    path.write_bytes(damage(path.read_bytes()))
    page.write_bytes(OLD)
    assert "fig8.nc: " in refusal(capsys, "report", "fig8", "--out", str(tmp_path))
    assert page.read_bytes() == OLD
