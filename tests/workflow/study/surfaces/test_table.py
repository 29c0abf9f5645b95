"""The table [surface]: random lines with roll-off and cut-off, or measured ones."""

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.settings import checked
from elastomer_friction.workflow.study.surfaces import table
from elastomer_friction.workflow.study.surfaces.surface import Surface
from elastomer_friction.workflow.study.surfaces.table import SURFACE, check_cutoff

HERE = {"file": "line.txt"}


def read_surface(given, folder):
    return table.read_surface(checked("surface", given, SURFACE), folder)


@pytest.fixture
def folder(tmp_path):
    x = 0.5 * np.arange(64)
    z = np.random.default_rng(3).normal(size=64).cumsum()
    np.savetxt(tmp_path / "line.txt", np.vstack([x, z, -z]).T, header="x(um) z(nm) w(nm)")
    return tmp_path


def refused(given, folder):
    with pytest.raises(UserError) as error:
        read_surface(given, folder)
    assert "\n" not in str(error.value)
    return str(error.value)


def test_a_random_surface_is_as_it_was(folder):
    assert read_surface({"length": 0.01}, folder) == Surface(0.01)
    assert read_surface({"length": 0.01}, folder).modes(100) == (0.0, 0)


def test_a_measured_line(folder):
    surface = read_surface(HERE, folder)
    assert surface.profile is not None
    assert surface.profile.heights.shape == (1, 128)
    assert surface.length == pytest.approx(32e-6)
    assert (surface.lines, surface.modes(128)) == ("measured", (0.0, 0))


def test_settings_of_a_measured_line(folder):
    settings = {"columns": [0, 1, 2], "units": ["mm", "um"], "detrend": "none", "periodic": "none"}
    surface = read_surface(HERE | settings | {"lines": "random-phase"}, folder)
    assert surface.profile is not None
    assert surface.profile.heights.shape == (2, 64)
    assert surface.length == pytest.approx(32e-3)
    assert surface.lines == "random-phase"


def test_a_hurst_exponent_that_no_line_of_this_slope_has_is_refused(folder):
    answer = refused(HERE | {"lines": "self-affine", "hurst": 0.0}, folder)
    assert answer.startswith("surface.hurst = 0.0: rms slope = ")
    assert "h/dx: lines of H = 0 have " in answer


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("length", 1.0),
        ("normalisation", "modal"),
        ("snap_spacing", True),
        ("rolloff", 1.0),
        ("cutoff", 1.0),
    ],
)
def test_keys_of_random_lines_are_refused_with_a_file(folder, key, value):
    answer = refused(HERE | {key: value}, folder)
    assert answer == f"surface.{key} = {value!r}: leave it out with surface.file, measured lines"


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("columns", [0, 1]),
        ("units", ["mm", "um"]),
        ("detrend", "line"),
        ("periodic", "taper"),
        ("lines", "random-phase"),
        ("hurst", 0.5),
    ],
)
def test_keys_of_measured_lines_are_refused_without_one(folder, key, value):
    answer = refused({"length": 1.0, key: value}, folder)
    assert answer == f"surface.{key} = {value!r}: goes with surface.file alone"


@pytest.mark.parametrize("columns", ["x", [0], [0, -1], [0, 1.0], [True, 1], ["x", "y", "z"]])
def test_columns_that_are_none_are_refused(folder, columns):
    assert refused(HERE | {"columns": columns}, folder).startswith("surface.columns = ")


@pytest.mark.parametrize("units", ["um", ["um"], ["um", "V"], ["um", 1], ["um", "um", "um"]])
def test_units_that_are_none_are_refused(folder, units):
    assert refused(HERE | {"units": units}, folder).endswith("two out of m, cm, mm, um, nm, å, pm")


@pytest.mark.parametrize("rolloff", [1e-3, 1e-4])
def test_a_roll_off_is_longer_than_the_cut_off(folder, rolloff):
    answer = refused({"length": 0.01, "cutoff": 1e-3, "rolloff": rolloff}, folder)
    assert answer == f"surface.rolloff = {rolloff}: must be longer than surface.cutoff = 0.001"


@pytest.mark.parametrize("key", ["rolloff", "cutoff"])
def test_no_wavelength_is_longer_than_the_line(folder, key):
    answer = refused({"length": 0.01, key: 0.011}, folder)
    assert answer == f"surface.{key} = 0.011: must not be longer than surface.length = 0.01"
    assert getattr(read_surface({"length": 0.01, key: 0.01}, folder), key) == 0.01


def test_elements_resolve_what_lines_are_made_of():
    for surface in (Surface(0.01, cutoff=2e-4), Surface(0.01, rolloff=2e-4)):
        check_cutoff(surface, (1e-4, 1e-5))
        with pytest.raises(UserError, match=r"must be two spacings or more: 0.0004 at grid.sp"):
            check_cutoff(surface, (1e-4, 2e-4))
    check_cutoff(Surface(0.01), (1e-4,))
