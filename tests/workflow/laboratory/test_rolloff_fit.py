"""Roll-off, H and cut-off of synthetic spectra, with errors that hold for pieces of a surface."""

import tomllib

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, draw_phases, sample_line
from elastomer_friction.workflow.laboratory.measured_spectrum import skewness_of, spectrum_of
from elastomer_friction.workflow.laboratory.rolloff_fit import fit_rolloff
from elastomer_friction.workflow.study.surfaces.profile import (
    map_of_array,
    map_of_lines,
    profile_of_array,
    profile_of_lines,
)
from elastomer_friction.workflow.study.surfaces.raw_lines import LineFile, Lines
from tests.support.commands import output, refusal
from tests.support.small import small_study

LENGTH, HURST, WAVES = 1e-3, 0.8, 8  # m; roll-off at L/8
FILE = LineFile(None, "a")


def piece(seed, shape=(512,), waves=WAVES, cut=np.inf, noise=0.0, copies=4):
    """Return a piece of a Gaussian surface that is longer by ``copies`` in every direction."""
    rng = np.random.default_rng(seed)
    size = [copies * n for n in shape]
    k = np.sqrt(sum(axis**2 for axis in np.meshgrid(*(np.fft.fftfreq(n, 1 / n) for n in size))))
    k /= copies
    power = np.where((k > 0) & (k <= cut), np.maximum(k, max(waves, 1 / copies)), np.inf)
    root = power ** -(HURST + 0.5 * len(shape))
    z = np.fft.ifftn(root * np.fft.fftn(rng.normal(size=size))).real
    z = z[tuple(slice(n) for n in shape)]
    return 1e-6 * (z / z.std() + noise * rng.normal(size=shape))


def fitted(z):
    step = LENGTH / z.shape[-1]
    if z.ndim == 2:
        profile = map_of_lines(FILE, Lines(z, step, "", step), "line", "mirror")
    else:
        profile = profile_of_lines(FILE, Lines(z[None], step, ""), "line", "mirror")
    return fit_rolloff(spectrum_of(profile), 2.0 * np.pi / LENGTH)


@pytest.mark.parametrize("shape", [(512,), (96, 96)])
def test_two_in_three_lie_within_one_standard_error(shape):
    fits = [fitted(piece(seed, shape)) for seed in range(30)]
    within = sum(abs(fit.hurst.value - HURST) < fit.hurst.error for fit in fits)
    assert 15 <= within <= 27
    ranges = [fit.rolloff for fit in fits if fit.rolloff is not None]
    assert len(ranges) >= 28
    within = sum(low < LENGTH / WAVES < high for low, _, high in ranges)
    assert 14 <= within <= 27


def test_the_lines_of_the_program_have_their_keys():
    modes = amplitudes(0.6, 2048, "modal", 16.0)
    z, _ = sample_line(modes, draw_phases(np.random.default_rng(0), 2048), 2048, 1)
    profile = profile_of_array(1e-6 * z, LENGTH)
    fit = fit_rolloff(spectrum_of(profile), 2.0 * np.pi / LENGTH)
    assert fit.hurst.value == pytest.approx(0.6, abs=0.01)
    assert fit.rolloff[1] == pytest.approx(LENGTH / 16.0, rel=0.03)
    assert spectrum_of(profile).slopes()[-1] == pytest.approx(profile.slope)


def test_the_spectrum_of_a_map_has_its_height_and_slope():
    profile = map_of_array(piece(1, (64, 64), cut=24, copies=1), LENGTH)
    spectrum = spectrum_of(profile)
    assert np.sum(spectrum.density * spectrum.area) == pytest.approx(profile.roughness**2)
    assert spectrum.slopes()[-1] == pytest.approx(profile.slope, rel=2e-3)  # q of a ring is a mean


def test_no_rolloff_within_the_length():
    fits = [fitted(piece(seed, waves=0)) for seed in range(5)]
    assert all(fit.rolloff is None for fit in fits)
    assert all(fit.least_rolloff > 0.2 * LENGTH for fit in fits)
    assert np.mean([fit.hurst.value for fit in fits]) == pytest.approx(HURST, abs=0.08)


def test_the_power_law_ends_at_a_cut_off_and_at_noise():
    cut = fitted(piece(3, cut=100))
    assert 60 < cut.last_q * LENGTH / (2.0 * np.pi) < 105
    assert "instrument" in cut.end_reason
    noisy = fitted(piece(3, noise=0.1))
    assert noisy.last_q < 0.6 * fitted(piece(3)).last_q
    assert "noise" in noisy.end_reason
    assert abs(noisy.hurst.value - HURST) < 3.0 * noisy.hurst.error


def test_skewness_is_zero_within_its_error():
    profiles = [map_of_array(piece(seed, (32, 32), copies=1), LENGTH) for seed in range(30)]
    found = [skewness_of(profile) for profile in profiles]
    assert 14 <= sum(abs(value) < error for value, error in found) <= 27


@pytest.fixture
def file(tmp_path):
    x = np.arange(512) * LENGTH / 512 * 1e6
    path = tmp_path / "line.csv"
    np.savetxt(path, np.c_[x, 1e9 * piece(2)], header="x (um), z (nm)", delimiter=",")
    return path


def test_the_command_prints_keys_of_a_study(capsys, file, tmp_path):
    text = output(capsys, "spectrum", str(file), "--figure", str(tmp_path / "new" / "s.png"))
    assert (tmp_path / "new" / "s.pdf").stat().st_size > 1000
    printed = text[: text.index("# figure")]
    for word in ("read as    lines", "# skewness", "# roll-off", "# cut-off", "# rms slope"):
        assert word in printed
    keys = tomllib.loads(printed)
    settings = [f"{table}.{key}={value}" for table in keys for key, value in keys[table].items()]
    study = small_study(*settings, "grid.roughness=1e-6")
    assert study.surface.rolloff == pytest.approx(LENGTH / WAVES, rel=0.5)


def test_the_points_of_a_map(capsys, tmp_path):
    x, y = np.meshgrid(np.arange(64.0), np.arange(64.0))
    z = 1e6 * piece(4, (64, 64))
    np.savetxt(
        tmp_path / "map.txt", np.c_[x.ravel(), y.ravel(), z.ravel()], header="x(um) y(um) z(um)"
    )
    text = output(
        capsys, "spectrum", str(tmp_path / "map.txt"), "--figure", str(tmp_path / "f.png")
    )
    assert "read as    a map" in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--detrend", "cubic"], "surface.detrend = 'cubic'"),
        (["--columns", "0,7"], "surface.columns = [0, 7]"),
        (["--units", "um,V"], "surface.units = ['um', 'V']"),
        (["--step", "-1"], "surface.step = -1.0"),
    ],
)
def test_wrong_options(capsys, file, arguments, answer):
    assert answer in refusal(capsys, "spectrum", str(file), *arguments)


def test_wrong_files(capsys, tmp_path):
    assert "none.csv" in refusal(capsys, "spectrum", str(tmp_path / "none.csv"))
    short = tmp_path / "short.csv"
    np.savetxt(short, np.c_[np.arange(16.0), np.arange(16.0) % 3], header="x (um) z (um)")
    assert "too few" in refusal(capsys, "spectrum", str(short))
