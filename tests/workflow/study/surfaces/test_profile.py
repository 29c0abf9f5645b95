"""Measured lines made ready for a study, from files and from Python."""

from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.surfaces.files import LineFile, read_lines
from elastomer_friction.workflow.study.surfaces.profile import (
    DETRENDS,
    PERIODICS,
    check_load,
    profile_of_array,
    profile_of_lines,
)

ROOT = Path(__file__).resolve().parents[4]
AFM = ROOT / "studies" / "measured_line" / "afm-lines.nc"
STYLUS = ROOT / "tests" / "resources" / "stylus-line.csv"
Z = 1e-6 * np.random.default_rng(3).normal(size=(2, 64)).cumsum(axis=1)
LENGTH = 1e-4


def read(path, detrend="line", periodic="mirror", units=()):
    file = LineFile(path, path.name, (), units)
    return profile_of_lines(file, read_lines(file), detrend, periodic)


def test_lines_of_a_microscope():
    """Rms height about 39 nm, rms slope about 0.11 after levelling (README of the data)."""
    profile = read(AFM)
    assert profile.heights.shape == (64, 1024)
    assert profile.roughness == pytest.approx(39e-9, rel=0.02)
    assert profile.slope == pytest.approx(0.11, rel=0.02)
    assert profile.measured_length == pytest.approx(10e-6, rel=1e-12)
    assert profile.length == pytest.approx(20e-6, rel=1e-12)
    assert profile.spacing == pytest.approx(10e-6 / 512, rel=1e-12)
    assert "mirrored: the period is the line followed by its reverse" in profile.notes
    assert "its line removed" in profile.notes


def test_the_line_of_a_stylus():
    profile = read(STYLUS, "parabola")
    assert profile.heights.shape == (1, 19200)
    assert profile.measured_length == pytest.approx(1500e-6, rel=1e-6)
    # Without tilt and bow tens of nm are left, as the instrument's own Rq of 11 nm suggests.
    assert profile.roughness == pytest.approx(38e-9, rel=0.02)
    assert "stand out as spikes, kept" in profile.notes


@pytest.mark.parametrize("periodic", PERIODICS)
@pytest.mark.parametrize("detrend", DETRENDS)
def test_every_way_is_told_and_makes_one_period(detrend, periodic):
    profile = read(AFM, detrend, periodic)
    copies = PERIODICS[periodic]
    assert profile.heights.shape == (64, 512 * copies)
    assert profile.length == pytest.approx(copies * profile.measured_length, rel=1e-14)
    assert ("nothing" if detrend == "none" else detrend) in profile.notes


def test_the_amplitudes_hold_the_mean_square_height_and_slope():
    profile = profile_of_array(Z, LENGTH)
    q = 2.0 * np.pi / LENGTH * np.arange(1, 33)
    assert np.sum(profile.amplitudes**2) / 2 == pytest.approx(profile.roughness**2, rel=1e-12)
    slope = np.sqrt(np.sum((profile.amplitudes * q) ** 2) / 2)
    assert profile.slope == pytest.approx(slope, rel=1e-12)
    single = [profile_of_array(z, LENGTH).amplitudes ** 2 for z in Z]
    np.testing.assert_allclose(np.mean(single, axis=0), profile.amplitudes**2, rtol=1e-12)


def test_a_profile_from_python_is_taken_as_it_is():
    profile = profile_of_array(Z[0], LENGTH)
    np.testing.assert_array_equal(profile.heights, Z[:1])
    assert (profile.length, profile.measured_length) == (LENGTH, LENGTH)
    assert profile.roughness == pytest.approx(Z[0].std(), rel=1e-13)
    assert profile_of_array(list(Z[0]), LENGTH).digest == profile.digest


def test_the_digest_is_that_of_the_heights_alone():
    profile = profile_of_array(Z, LENGTH)
    assert profile_of_array(Z.copy(order="F"), 2.0 * LENGTH).digest == profile.digest
    assert profile_of_array(Z.reshape(4, 32), LENGTH).digest != profile.digest
    assert profile_of_array(np.nextafter(Z, 1.0), LENGTH).digest != profile.digest


def test_heights_cannot_be_changed():
    own = Z.copy()
    profile = profile_of_array(own, LENGTH)
    with pytest.raises(ValueError, match="read-only"):
        profile.heights[0, 0] = 1.0
    own[0, 0] = 1.0  # those of the caller can, and are others
    np.testing.assert_array_equal(profile.heights, Z)


@pytest.mark.parametrize(
    ("heights", "words"),
    [
        ("line", "profile: must be an array of heights in m"),
        (
            np.ma.array(Z, mask=np.arange(64) // 10 == [[3]] * len(Z)),
            "profile: sample 31 of line 1 is nan: all must be finite, 20 of 128 are masked; fill",
        ),
        ([[1.0], [1.0, 2.0]], "profile: must be an array of heights in m"),
        (Z[0, :7], "profile: has the shape (1, 7): must hold at least 8 heights"),
        (Z.reshape(2, 8, 8), "profile: has the shape (2, 8, 8): must hold"),
        (np.where(np.arange(64) == 5, np.nan, Z[0]), "profile: sample 6 of line 1 is nan"),
        (np.full(20, 3.0), "profile: line 1 of 1 is flat"),
        (1e6 * Z, "must lie between 1e-05 and 30: give heights and length both in m"),
        (1e-6 * Z, "must lie between 1e-05 and 30: give heights and length both in m"),
    ],
)
def test_profiles_that_are_none_are_refused_in_a_line(heights, words):
    with pytest.raises(UserError) as error:
        profile_of_array(heights, LENGTH)
    assert words in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("load", [1e-8, 1e6, 0.9e-8, 1.1e6, np.nan])
def test_loads_of_other_units_are_refused(load):
    profile, loads = profile_of_array(Z, LENGTH), np.array([load, 1.0])
    if 1e-8 <= load <= 1e6:
        check_load(profile, loads)
        return
    with pytest.raises(UserError, match=r"grid.normal_force: F_N/\(4 G L h\) runs from .* in Pa"):
        check_load(profile, loads)
