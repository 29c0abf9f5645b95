"""The table [surface], and what the lines of a surface are."""

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, rms_height, rms_slope
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.settings import checked
from elastomer_friction.workflow.study.surfaces import table
from elastomer_friction.workflow.study.surfaces.profile import profile_of_array
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


def test_lines_are_random_or_measured(folder):
    surface = read_surface({"length": 0.01}, folder)
    assert surface == Surface(0.01)
    assert (surface.modes(100), surface.identity, surface.description) == ((0.0, 0), "", "")
    assert surface.amplitudes is None
    surface = read_surface(HERE, folder)
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


@pytest.mark.parametrize("key", ["rolloff", "cutoff"])
def test_a_wavelength_may_be_as_long_as_the_line(folder, key):
    assert getattr(read_surface({"length": 0.01, key: 0.01}, folder), key) == 0.01


def test_elements_resolve_what_lines_are_made_of():
    for surface in (Surface(0.01, cutoff=2e-4), Surface(0.01, rolloff=2e-4)):
        check_cutoff(surface, (1e-4, 1e-5))
        with pytest.raises(UserError, match=r"must be two spacings or more: 0.0004 at grid.sp"):
            check_cutoff(surface, (1e-4, 2e-4))
    check_cutoff(Surface(0.01), (1e-4,))


Z = 1e-8 * np.random.default_rng(3).normal(size=(3, 64)).cumsum(axis=1)
PROFILE = profile_of_array(np.hstack([Z, Z[:, ::-1]]), 1e-5)
MEASURED = Surface(1e-5, profile=PROFILE)


def test_roll_off_and_cut_off_are_modes_of_the_line():
    surface = Surface(0.01, rolloff=2e-3, cutoff=4e-4)
    rolloff, cutoff = surface.modes(1000)
    assert rolloff == pytest.approx(5.0)
    assert cutoff == 25  # rounding of 0.01/4e-4 aside
    assert surface.modes(50) == (rolloff, 0)  # two spacings: none
    assert amplitudes(0.7, 1000, "modal", rolloff, cutoff).size == 500


def test_random_phase_lines_have_the_power_spectrum_of_the_measured_ones():
    like = MEASURED._replace(lines="random-phase")
    assert MEASURED.amplitudes is None  # those lines are taken as they are
    np.testing.assert_array_equal(like.amplitudes, PROFILE.amplitudes)


def test_self_affine_lines_have_the_rms_height_and_slope_of_the_measured_ones():
    like = MEASURED._replace(lines="self-affine", hurst=0.9).amplitudes
    assert rms_height(like) == pytest.approx(PROFILE.roughness, rel=1e-12)
    assert rms_slope(like, 128) / PROFILE.spacing == pytest.approx(PROFILE.slope, rel=1e-12)
    assert like[59] / like[29] == pytest.approx(2.0**-1.4, rel=1e-12)


def test_every_kind_of_lines_has_its_identity_and_its_words():
    kinds = [{}, {"lines": "random-phase"}, {"lines": "self-affine"}]
    kinds += [{"lines": "self-affine", "hurst": 0.9}]
    surfaces = [MEASURED._replace(**kind) for kind in kinds]
    surfaces.append(Surface(1e-5, profile=profile_of_array(Z, 1e-5)))
    assert len({surface.identity for surface in surfaces}) == len(surfaces)
    assert len({surface.description for surface in surfaces}) == len(surfaces)
    like = surfaces[1].description
    assert like.startswith(
        f"random lines of the power spectrum of {PROFILE.notes}; heights are Gauss"
    )
