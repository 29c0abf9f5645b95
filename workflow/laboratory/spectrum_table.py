"""Parameters of a measured spectrum in words, and as the keys of a study of random surfaces."""

import math

import numpy as np
from scipy.fft import next_fast_len

from ..ground import UserError, with_error
from ..report import plus_minus
from ..study import Profile
from .measured_spectrum import MeasuredSpectrum, skewness_of
from .rolloff_fit import RolloffFit

SPACINGS = {1: 4, 2: 2}  # per cut-off, of lines and of maps
MAX_MISFIT = 0.5  # of a power law, relative to C
SLOPE_CUTS = 2, 4, 8, 16  # cut-offs, in measured ones, for which the rms slope is printed


def describe_spectrum(profile: Profile, spectrum: MeasuredSpectrum, fit: RolloffFit) -> list[str]:
    """Return the parameters as comments of TOML, and the keys of random surfaces like it."""
    keys, slope = _keys(profile, spectrum, fit)
    shortest = 2.0 * math.pi / fit.last_q
    waves, slopes = 2.0 * math.pi / spectrum.q, spectrum.slopes()
    rolloff = f"not within the length: shorter than {fit.least_rolloff:.3g} m is excluded"
    if fit.rolloff is not None:
        rolloff = "{1:.4g} m, from {0:.3g} to {2:.3g} m".format(*fit.rolloff)
    at = [cut * shortest for cut in (1, *SLOPE_CUTS) if cut * shortest < waves[0]]
    cuts = [f"{slopes[waves >= wave * (1.0 - 1e-9)][-1]:.3g}" for wave in at]
    percent = 100.0 * spectrum.height_error(fit.mode_variance)
    kind = "lines" if spectrum.falling == 1 else "a map: rms slope of the full gradient"
    rows = {
        "read as": kind,
        "h": f"{profile.roughness:.4g} m{plus_minus(percent, f'{percent:.0f} %')}",
        "skewness": with_error(*skewness_of(profile)),
        "H": f"{with_error(*fit.hurst)}, from waves of "
        f"{2.0 * math.pi / fit.first_q:.3g} to {shortest:.3g} m",
        "roll-off": rolloff,
        "cut-off": f"{shortest:.4g} m: {fit.end_reason}",
        "rms slope": f"{', '.join(cuts)} of waves above {', '.join(f'{w:.3g}' for w in at)} m",
        "": f"{slope:.3g} of random surfaces of the keys below",
    }
    if fit.misfit > 0.0:
        rows["misfit"] = f"{100.0 * fit.misfit:.0f} % of C, counted in the errors"
        if fit.misfit > MAX_MISFIT:
            rows["misfit"] += '; not a power law: use the file itself, or lines = "random-phase"'
    head = [f"# {note}" for note in profile.notes.split("; ")]
    return [*head, *(f"# {name:10} {text}" for name, text in rows.items()), *keys]


def spectrum_rows(spectrum: MeasuredSpectrum, last_q: float) -> list[str]:
    """Return the lines of a file for ``surface.spectrum`` of the kind "2D", up to last_q (1/m).

    Raises UserError for the spectrum of lines, which scatters too much to be inverted.
    """
    if spectrum.falling == 1:
        raise UserError("--out: needs a map; for lines, use the printed keys")
    resolved = (spectrum.q <= last_q * (1.0 + 1e-9)) & (spectrum.density > 0.0)
    rows = zip(spectrum.q[resolved], spectrum.density[resolved], strict=True)
    return ["q [1/m], C [m^4]", *(f"{q:.10g}, {density:.10g}" for q, density in rows)]


def _keys(profile: Profile, spectrum: MeasuredSpectrum, fit: RolloffFit) -> tuple[list[str], float]:
    """Return the keys of random surfaces of the fitted spectrum, and their rms slope."""
    length = float(f"{profile.measured_length:.6g}")
    cutoff = float(f"{2.0 * math.pi / fit.last_q:.4g}")
    elements = next_fast_len(math.ceil(SPACINGS[spectrum.falling] * length / cutoff - 1e-6), True)
    hurst = min(max(fit.hurst.value, 0.0), 1.0)
    rolloff = [] if fit.rolloff is None else [f"rolloff = {fit.rolloff[1]:.4g}"]
    k = np.arange(1.0, length / cutoff + 1e-6)
    flat = 0.0 if fit.rolloff is None else length / fit.rolloff[1]
    power = k ** (spectrum.falling - 1) * np.maximum(k, flat) ** -(2.0 * hurst + spectrum.falling)
    mean_square = (power @ k**2) / power.sum() * (2.0 * math.pi / length) ** 2
    table = ["[surface]", f"length = {length:g}", *rolloff, f"cutoff = {cutoff:g}", "[grid]"]
    table += [f"hurst = {hurst:.3f}", f"roughness = {profile.roughness:.4g}"]
    table.append(f"spacing = {length / elements:.12g}")
    return table, profile.roughness * math.sqrt(mean_square)
