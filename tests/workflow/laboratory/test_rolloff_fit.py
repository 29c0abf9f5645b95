"""Roll-off, H and cut-off of synthetic spectra, with errors that hold for pieces of a surface."""

import tomllib

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, draw_phases, sample_line
from elastomer_friction.workflow.laboratory.measured_spectrum import skewness_of, spectrum_of
from elastomer_friction.workflow.laboratory.rolloff_fit import fit_rolloff
from elastomer_friction.workflow.study.surfaces.profile import (
    map_of_lines,
    profile_of_array,
    profile_of_lines,
)
from elastomer_friction.workflow.study.surfaces.raw_lines import LineFile, Lines
from elastomer_friction.workflow.study.surfaces.spectrum_file import read_spectrum
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
        profile = map_of_lines(FILE, Lines(z, step, "", "", step), "line", "mirror")
    else:
        profile = profile_of_lines(FILE, Lines(z[None], step, "", ""), "line", "mirror")
    return fit_rolloff(spectrum_of(profile), 2.0 * np.pi / LENGTH)


@pytest.mark.parametrize("shape", [(512,), (96, 96)])
def test_two_in_three_lie_within_one_standard_error(shape):
    fits = [fitted(piece(seed, shape)) for seed in range(100, 130)]
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
    profile = profile_of_array(piece(1, (64, 64), cut=24, copies=1), LENGTH, as_map=True)
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
    profiles = [
        profile_of_array(piece(seed, (32, 32), copies=1), LENGTH, as_map=True) for seed in range(30)
    ]
    assert 14 <= sum(abs(value) < error for value, error in map(skewness_of, profiles)) <= 27


def file_of(folder, z):
    """Write a line, or the points of a map, and return the path as a string."""
    places = np.meshgrid(*(np.arange(n) * LENGTH / z.shape[-1] * 1e6 for n in z.shape))
    columns = [*(place.ravel() for place in places), 1e9 * z.ravel()]
    header = "x (um), z (nm)" if z.ndim == 1 else "x (um), y (um), z (nm)"
    np.savetxt(folder / "z.csv", np.transpose(columns), header=header, delimiter=",")
    return str(folder / "z.csv")


@pytest.mark.parametrize(
    ("shape", "kind", "body"), [((512,), "lines", "foundation"), ((64, 64), "a map", "half-space")]
)
def test_the_command_prints_keys_of_a_study(capsys, tmp_path, shape, kind, body):
    figure = tmp_path / "new" / "s.png"
    path = file_of(tmp_path, piece(2, shape))
    printed = output(capsys, "spectrum", path, "--figure", str(figure)).partition("# figure")[0]
    assert figure.with_suffix(".pdf").stat().st_size > 1000
    for word in (f"read as    {kind}", "# skewness", "# roll-off", "# cut-off", "# rms slope"):
        assert word in printed
    keys = tomllib.loads(printed)
    settings = [f"{table}.{key}={value}" for table in keys for key, value in keys[table].items()]
    study = small_study(*settings, "grid.roughness=1e-6", f"scene.body={body}")
    assert study.surface.rolloff == pytest.approx(LENGTH / WAVES, rel=0.5)


def test_a_written_spectrum_has_the_height_of_the_map(capsys, tmp_path):
    """The mean square height is int C d^2q over rings as wide as the first wave number."""
    z, out, figure = piece(2, (64, 64), copies=1), tmp_path / "c.csv", str(tmp_path / "s.png")
    path = file_of(tmp_path, z)
    output(capsys, "spectrum", path, "--periodic", "none", "--figure", figure, "--out", str(out))
    read, _ = read_spectrum({"file": "c.csv", "kind": "2D", "times": 1.0}, tmp_path)
    power = np.array(read.q) * np.array(read.density)
    assert 2.0 * np.pi * power.sum() * 2.0 * np.pi / LENGTH == pytest.approx(np.var(z), rel=0.1)
    line = file_of(tmp_path, piece(2))
    assert "--out" in refusal(capsys, "spectrum", line, "--figure", figure, "--out", str(out))
    assert "is the measurement itself" in refusal(capsys, "spectrum", line, "--out", line)


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--detrend", "cubic"], "--detrend = 'cubic'"),
        (["--columns", "0,7"], "--columns = [0, 7]"),
        (["--step", "-1"], "--step = -1.0"),
        ([], "too few"),
    ],
)
def test_wrong_input_is_one_line(capsys, tmp_path, arguments, answer):
    path = file_of(tmp_path, 1e-6 * (np.arange(16.0) % 3))
    assert answer in refusal(capsys, "spectrum", path, *arguments)
    assert "none.csv" in refusal(capsys, "spectrum", str(tmp_path / "none.csv"))
