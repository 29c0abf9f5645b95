"""Spectrum of an elastomer: a spring, relaxing branches and possibly a dashpot.

The relaxation modulus, in units of the relaxed modulus G and of the relaxation time tau, is

    G(t) / G = 1 + sum_b g_b exp(-t / t_b) + eta delta(t),

a Prony series and a dashpot in parallel. With tau = (eta + sum_b g_b t_b) / G, the fields of a
Spectrum satisfy viscosity + sum moduli * times = 1; no formula relies on it.
"""

from typing import NamedTuple

import numpy as np


class Spectrum(NamedTuple):
    """A linear viscoelastic material; hashable, because it is part of keys."""

    moduli: tuple[float, ...]  # g_b / G of the branches
    times: tuple[float, ...]  # t_b / tau of the branches, ascending
    viscosity: float  # eta / (G tau): of the dashpot


KELVIN = Spectrum((), (), 1.0)

# Shortest step with a dashpot, in tau. In a step, displacements change by a fraction dt, so their
# relative rounding error of 1e-16 causes one of 1e-16 / dt in the force.
MIN_DASHPOT_STEP = 1e-10


def min_step(spectrum: Spectrum) -> float:
    """Return the shortest step (in tau) in which rounding does not hide the force.

    Without a dashpot the stiffness of a step is at most that of the glass, and the fastest branch
    sets the limit; slower branches accumulate their input.
    """
    if spectrum.viscosity > 0.0:
        return MIN_DASHPOT_STEP
    return MIN_DASHPOT_STEP * min(1.0, *spectrum.times)


def relaxation_modulus(spectrum: Spectrum, t: np.ndarray) -> np.ndarray:
    """Return G(t)/G at times t > 0 (in tau) after a step of strain; shape of t."""
    t = np.asarray(t, float)
    decays = [g * np.exp(-t / tb) for g, tb in zip(spectrum.moduli, spectrum.times, strict=True)]
    return np.ones_like(t) + sum(decays)


def complex_modulus(spectrum: Spectrum, omega: np.ndarray) -> np.ndarray:
    """Return (G' + i G'')/G at angular frequencies omega (in 1/tau); complex, shape of omega."""
    turn = 1j * np.asarray(omega, float)
    branches = [
        g * (turn * tb) / (1.0 + turn * tb)
        for g, tb in zip(spectrum.moduli, spectrum.times, strict=True)
    ]
    return 1.0 + turn * spectrum.viscosity + sum(branches)
