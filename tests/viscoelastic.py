"""Materials, and a plain march of elements with internal variables, shared by several tests."""

import numpy as np

from elastomer_friction.kernels.rheology.law import Elements, law_of
from elastomer_friction.kernels.rheology.prony import Prony
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum
from tests.references import sorted_root


def of_unit_tau(moduli, times, viscosity=0.0) -> Spectrum:
    """Return a Spectrum with times in units of tau = (eta + sum g_b t_b) / G."""
    tau = viscosity + float(np.dot(moduli, times))
    scaled = tuple(float(t / tau) for t in times)
    return Spectrum(tuple(float(g) for g in moduli), scaled, viscosity / tau)


STANDARD = of_unit_tau((10.0,), (5e-3,))
PRONY3 = of_unit_tau((2.0, 5.0, 30.0), (0.3, 0.02, 1e-3))
# Crosslinked SBR at 20 C, fitted to the moduli of doi:10.1002/polb.24812 (in MPa, seconds).
SBR_MODULI = (73.6, 175.0, 115.0, 26.9, 6.42, 1.57, 0.402, 0.117, 0.0458, 0.0275, 0.0221, 0.0201)
SBR = of_unit_tau(np.array([*SBR_MODULI, 0.0160]) / 0.3065, 10.0 ** np.arange(-10, 3))
WITH_DASHPOT = of_unit_tau((2.0, 5.0), (0.3, 0.02), 0.05)
MATERIALS = {
    "Kelvin": KELVIN,
    "standard": STANDARD,
    "Prony3": PRONY3,
    "dashpot": WITH_DASHPOT,
    "SBR": SBR,
}


class Foundation:
    """Elements at x_i under a moving line, in plain numpy, all stepped in every step."""

    def __init__(self, form, z, elements: Elements):
        self.form, self.z, self.d = form, z, elements.d
        self.memory, self.p, self.position = elements.memory.copy(), elements.p.copy(), 0
        self.laws: dict = {}

    def step(self, way: int, dt: float, load: float | None = None, d: float | None = None):
        """Move the line by ``way`` samples in dt, under a load or at an indentation d."""
        if dt not in self.laws:
            self.laws[dt] = law_of(self.form, dt)
        law, self.position = self.laws[dt], self.position + way
        if isinstance(law, Prony):
            at_rest = law.decay[:, None] * self.memory - np.outer(law.stale, self.p)
            w = at_rest.sum(0)
        else:
            at_rest, u = law.decay[:, None] * self.memory[:-1], self.memory[-1]
            drag = law.gain.sum() + law.drag
            w = (drag * u - at_rest.sum(0)) / law.stiffness
        c = np.roll(self.z, self.position) - w
        self.d = sorted_root(c, load / law.stiffness) if d is None else d
        self.p = law.stiffness * np.maximum(0.0, self.d - c)
        if isinstance(law, Prony):
            self.memory = at_rest - np.outer(law.fresh, self.p)
        else:
            end = w - self.p / law.stiffness
            self.memory = np.vstack([at_rest + np.outer(law.gain, end - u), end])
