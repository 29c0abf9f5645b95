"""Figure of a measured power spectrum: C(q) with its fit, and the rms slope over the cut-off."""

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from ..ground import with_error
from ..report import COLOURS, legend_in_room, write_below
from .measured_spectrum import MeasuredSpectrum
from .rolloff_fit import RolloffFit


def figure_of_spectrum(spectrum: MeasuredSpectrum, fit: RolloffFit) -> Figure:
    """Return the figure of a spectrum and its fit."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(6.4, 2.8))
    bins, q = fit.bins, np.exp(fit.bins.log_q)
    error = bins.density * np.sqrt(fit.mode_variance / bins.modes)
    left.plot(spectrum.q, spectrum.density, ".", ms=0.6, color="0.6", label="modes or rings")
    left.errorbar(q, bins.density, np.minimum(error, 0.99 * bins.density), fmt="o", color="k", ms=2)
    label = f"H = {with_error(*fit.hurst)}"
    left.plot(q[: fit.model.size], fit.model, "-", color=COLOURS[4], label=label)
    for ax, places in ((left, lambda wave: 2.0 * np.pi / wave), (right, lambda wave: wave)):
        if fit.rolloff is not None:
            low, middle, high = map(places, fit.rolloff)
            ax.axvspan(low, high, color=COLOURS[0], alpha=0.2, lw=0.0)
            ax.axvline(middle, color=COLOURS[0], lw=0.8, label="roll-off")
        end = places(2.0 * np.pi / fit.last_q)
        ax.axvline(end, color=COLOURS[2], ls="--", lw=0.8, label="cut-off")
    name = "C_{1D}" if spectrum.falling == 1 else "C_{2D}"
    unit = "m³" if spectrum.falling == 1 else "m⁴"
    shown = spectrum.q >= fit.first_q * (1.0 - 1e-9)
    left.set(xscale="log", yscale="log", xlabel="$q$ (1/m)", ylabel=f"${name}$ ({unit})")
    left.set_ylim(0.3 * max(bins.density.min(), 1e-4 * fit.model.min()))
    left.set_title("(a) power spectrum")
    opaque = {"frameon": True, "framealpha": 1.0, "edgecolor": "none"}  # over the roll-off
    legend_in_room(left, 0.3, ncols=2, markerscale=4.0, **opaque)
    right.plot(2.0 * np.pi / spectrum.q[shown], spectrum.slopes()[shown], "-", color="k")
    right.set(xscale="log", yscale="log", xlabel="shortest wave (m)", ylabel="rms slope")
    right.set_title("(b) slope of all waves that are longer")
    write_below(figure, "Bars and the band of the roll-off show one standard error.")
    return figure
