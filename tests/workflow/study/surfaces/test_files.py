"""Files of measured lines: the readers by suffix, and what cannot be read."""

import netCDF4
import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.surfaces.files import read_lines
from elastomer_friction.workflow.study.surfaces.raw_lines import LineFile
from tests.support.faults import endless

X = np.arange(16) * 0.5
Z = np.random.default_rng(6).normal(size=(3, 16))


def read(path, columns=(), units=()):
    return read_lines(LineFile(path, path.name, columns, units))


def test_npy(tmp_path):
    path = tmp_path / "line.npy"
    np.save(path, np.vstack([X, Z]).T.astype(np.float32))
    lines = read(path, (0, 2), ("um", "nm"))
    np.testing.assert_allclose(lines.heights, Z[[1]] * 1e-9, rtol=1e-6)
    with pytest.raises(UserError, match=r"surface.units: missing: 'line.npy' names none"):
        read(path)


def netcdf(path, dimensions=("line", "x"), unit="units", more=()):
    with netCDF4.Dataset(path, "w") as data:
        data.createDimension("line", 3)
        data.createDimension("x", 16)
        x = data.createVariable("x", "f8", ("x",))
        x.setncattr(unit, "um")
        x[:] = X
        for name in ("height", *more):
            z = data.createVariable(name, "f4", dimensions, fill_value=-999.0)
            z.setncattr(unit, "nm")
            z[:] = Z if dimensions == ("line", "x") else Z.T
    return path


@pytest.mark.parametrize("dimensions", [("line", "x"), ("x", "line")])
@pytest.mark.parametrize("unit", ["units", "unit"])
def test_netcdf(tmp_path, dimensions, unit):
    lines = read(netcdf(tmp_path / "l.nc", dimensions, unit))
    np.testing.assert_allclose(lines.heights, Z * 1e-9, rtol=1e-6)
    assert lines.step == pytest.approx(0.5e-6)


def test_netcdf_of_several_variables_needs_names(tmp_path):
    path = netcdf(tmp_path / "l.nc", more=("friction",))
    with pytest.raises(UserError, match="holds the variables x, height, friction: name positions"):
        read(path)
    np.testing.assert_allclose(read(path, ("x", "friction")).heights, Z * 1e-9, rtol=1e-6)
    with pytest.raises(UserError, match="holds the variables x, height, friction: name positions"):
        read(path, ("x", "depth"))
    with pytest.raises(
        UserError, match="'height' does not hold the positions of the samples of 'x'"
    ):
        read(path, ("height", "x"))


def test_a_missing_value_of_netcdf_is_named(tmp_path):
    path = netcdf(tmp_path / "l.nc")
    with netCDF4.Dataset(path, "a") as data:
        data["height"][2, 7] = -999.0  # its fill value
    with pytest.raises(
        UserError, match=r"'l.nc': 1 of 48 samples are missing in 1 of 3 lines, .* sample 8"
    ):
        read(path)


def broken(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(b"\x89HDF\r\n\x1a\n no more" if name == "l.nc" else b"nothing")
    return path


@pytest.mark.parametrize("name", ["l.nc", "l.npy", "l.csv", "no.txt", "no.nc", "no.npy"])
def test_files_that_are_none_are_refused_in_a_line(tmp_path, name):
    path = tmp_path / name if name.startswith("no") else broken(tmp_path, name)
    with pytest.raises(UserError, match=f"surface.file = '{name}': ") as error:
        read(path)
    assert "\n" not in str(error.value)


def test_a_small_file_that_promises_more_than_memory_holds_is_refused(tmp_path):
    path = tmp_path / "l.nc"
    with netCDF4.Dataset(path, "w") as data:
        data.createDimension("x", 10**11)
        for name, unit in (("x", "um"), ("height", "nm")):
            data.createVariable(name, "f8", ("x",), chunksizes=(10**6,)).units = unit
    np.save(tmp_path / "l.npy", np.zeros((4, 2)))
    content = (tmp_path / "l.npy").read_bytes()
    (tmp_path / "l.npy").write_bytes(
        content.replace(b"(4, 2), }           ", b"(40000000000, 2), } ")
    )
    for name, why in (("l.nc", "it claims more data than fits into memory"), ("l.npy", "mmap len")):
        assert (tmp_path / name).stat().st_size < 10**5
        with pytest.raises(UserError, match=f"surface.file = '{name}': cannot be read: {why}"):
            read(tmp_path / name)


def test_a_netcdf_file_that_is_forged_is_refused_and_does_not_hang(tmp_path):
    path = netcdf(tmp_path / "l.nc")
    with netCDF4.Dataset(path, "a") as data:
        data.createVariable("by", str, ("x",))[:] = np.array(["a tester"] * 16, object)
    path.write_bytes(endless(path.read_bytes()))
    with pytest.raises(UserError, match=r"'l.nc': cannot be read: reading it does not end"):
        read(path)


def test_arrays_that_are_no_table_are_refused(tmp_path):
    path = tmp_path / "l.npy"
    for array in (X, Z[:, :1], np.array([["a", "b"]] * 9)):
        np.save(path, array)
        with pytest.raises(UserError, match="must be numbers, a row per sample"):
            read(path)
    for old, new in ((b"(16,)", b"(16,("), (b"(16,)", b"(-1,)"), (b"'<f8'", b"|O   ")):
        np.save(path, X)
        path.write_bytes(path.read_bytes().replace(old, new))
        with pytest.raises(UserError, match="cannot be read: "):
            read(path)
    np.savez(tmp_path / "l", a=X, b=X)
    (tmp_path / "l.npz").rename(path)
    with pytest.raises(UserError, match="holds several arrays"):
        read(path)


def instrument(tmp_path):
    """Return the path of a file that is neither text nor known here."""
    path = tmp_path / "scan.di"
    path.write_bytes(b"\x00\x01 heights")
    return path


@pytest.fixture
def stand_in(tmp_path, monkeypatch):
    """Return a function that writes the source of a module in place of SurfaceTopography."""
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "modules"))
    (tmp_path / "modules").mkdir()
    return (tmp_path / "modules" / "SurfaceTopography.py").write_text


def test_other_files_need_surface_topography(tmp_path, stand_in):
    stand_in("raise ImportError")  # as if not installed
    with pytest.raises(UserError, match="not installed: pip install SurfaceTopography"):
        read(instrument(tmp_path))


TOPOGRAPHY = """
from types import SimpleNamespace
import numpy as np
Z = np.array({z})
def read_topography(path):
    print("a reader that prints")
    return SimpleNamespace(
        dim={dim}, unit="um", nb_grid_pts=(16, 3), pixel_size=(0.5, 0.7),
        heights=lambda: np.ma.array(Z.T), positions_and_heights=lambda: (np.arange(16) * 0.5, Z[0]),
    )
"""


@pytest.mark.parametrize(("dim", "expected"), [(2, Z), (1, Z[:1])])
def test_maps_and_lines_of_surface_topography(tmp_path, stand_in, dim, expected):
    stand_in(TOPOGRAPHY.format(z=Z.tolist(), dim=dim))
    lines = read(instrument(tmp_path))
    np.testing.assert_allclose(lines.heights, expected * 1e-6)
    assert lines.row_spacing == (pytest.approx(0.7e-6) if dim == 2 else None)
    assert lines.step == pytest.approx(0.5e-6)


READERS = {
    "raise KeyError('no channel')": r"no reader of .* recognises it \('no channel'\)",
    "bytes(2**31)": "it claims more data than its size allows",
    "signal.setitimer(signal.ITIMER_PROF, 0.1)\n    while True: pass": "reading it does not end",
    "os.kill(os.getpid(), signal.SIGSEGV)": "reading it ends the process",
    "os.kill(os.getpid(), signal.SIGKILL)": "the process that reads it was killed, as for lack of",
}


@pytest.mark.parametrize(("body", "reason"), READERS.items(), ids=range(len(READERS)))
def test_files_that_surface_topography_cannot_read_are_refused(tmp_path, stand_in, body, reason):
    stand_in(f"import os, signal\ndef read_topography(path):\n    {body}\n")
    with pytest.raises(UserError, match=rf"surface.file = 'scan.di': cannot be read: {reason}"):
        read(instrument(tmp_path))


def test_a_file_that_takes_its_content_from_another_one_is_refused(tmp_path):
    h5py = pytest.importorskip("h5py")
    layout = h5py.VirtualLayout((16,), "f8")
    for name in ("external.nc", "virtual.nc", "linked.nc", "external.h5"):
        with (
            h5py.File(tmp_path / "other.nc", "w") as other,
            h5py.File(tmp_path / name, "w") as file,
        ):
            other["z"] = X
            file.create_dataset("x", data=X).attrs["units"] = "um"
            if name == "linked.nc":
                file["height"] = h5py.ExternalLink(tmp_path / "other.nc", "z")
            elif name == "virtual.nc":
                layout[:] = h5py.VirtualSource(tmp_path / "other.nc", "z", (16,))
                file.create_virtual_dataset("height", layout)
            else:
                outside = [(str(tmp_path / "other.nc"), 0, 128)]
                file.create_dataset("height", (16,), "f8", external=outside)
        with pytest.raises(UserError, match="its content is in another file"):
            read(tmp_path / name, ("x", "height"), ("um", "um"))


@pytest.mark.filterwarnings("ignore::ImportWarning")  # of its fallback without MPI
def test_surface_topography_itself(tmp_path):
    """Where it is installed: a map in a format of its own."""
    topography = pytest.importorskip("SurfaceTopography")
    path = tmp_path / "map.nc"
    topography.Topography(Z.T, (8.0, 1.5), unit="nm").to_netcdf(path)
    path.rename(tmp_path / "map.map")
    lines = read(tmp_path / "map.map")
    np.testing.assert_allclose(lines.heights, Z * 1e-9)
    assert lines.step == pytest.approx(0.5e-9)


def test_heights_of_an_array_without_positions(tmp_path):
    path = tmp_path / "l.npy"
    np.save(path, Z[0])
    asked = LineFile(path, path.name, (), ("um", "nm"), 0.5e-6)
    lines = read_lines(asked)
    np.testing.assert_allclose(lines.heights, Z[:1] * 1e-9)
    assert lines.step == 0.5e-6
