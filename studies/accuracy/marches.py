"""Common alternatives: time marches of the whole line, from rest, with a search for d each step.

Implicit Euler on the same samples as the kernels: at equal m they must give equal numbers. What
differs is how: no steady solver, no exact jump, every element at every step.
"""

import numpy as np
from scipy.optimize import brentq

from elastomer_friction.kernels import Line

SEARCH = 1e-13  # width in h at which a search for d ends


class NumpyMarch:
    """Plain numpy: arrays over the whole line, a library root finder for d."""

    def __init__(self, line: Line, load: float) -> None:
        self.line, self.load = line, load
        self.u = np.zeros(line.z.size)  # in the frame of the line

    def advance(self, steps: int, dt: float) -> np.ndarray:
        """Move the line by ``steps`` samples in steps of dt (tau); return mu of each, in h/dx."""
        z, slope = self.line.z, self.line.slope
        decay, stiffness = 1.0 / (1.0 + dt), 1.0 + 1.0 / dt
        mu = np.empty(steps)
        for step in range(steps):
            free = decay * np.roll(self.u, -1)
            reach = free - z
            target = self.load / stiffness * z.size
            low = -reach.max()

            def excess(d, reach=reach, target=target):
                return np.maximum(reach + d, 0.0).sum() - target

            d = brentq(excess, low, low + target, xtol=SEARCH)
            force = np.maximum(reach + d, 0.0)
            self.u = free - force
            mu[step] = (force * slope).sum() / force.sum()  # not @: one thread only
        return mu


class TamaasMarch:
    """The package tamaas as Winkler foundation with one Maxwell branch tau_1 << dt.

    The backward Euler step of the branch is then that of a Kelvin element. Its tolerance makes
    the numbers agree to about 1e-7. Raises ImportError where tamaas is not installed, and
    ArithmeticError where it fails: with one touching element only.
    """

    BRANCH = 1e-8  # tau_1 / tau
    TOLERANCE = 1e-10
    OPERATOR = "Westergaard::neumann"

    def __init__(self, line: Line, load: float) -> None:
        import tamaas

        tamaas.set_log_level(tamaas.LogLevel.error)
        self.load, self.surface, self.slope = load, -line.z, line.slope.copy()
        self.model = tamaas.Model(tamaas.model_type.basic_1d, [1.0], [line.z.size])
        self.model.nu, self.model.E = 0.0, 2.0  # shear modulus 1
        self.model.be_engine.registerNeumann()
        self.solver = tamaas.MaxwellViscoelastic(
            self.model, self.surface, self.TOLERANCE, 1.0, [1.0 / self.BRANCH], [self.BRANCH]
        )
        self.solver.setIntegralOperator(self.OPERATOR)
        self.model.operators[self.OPERATOR]["influence"][...] = 1.0  # u = p: springs

    def advance(self, steps: int, dt: float) -> np.ndarray:
        """Move the line by ``steps`` samples in steps of dt (tau); return mu of each, in h/dx."""
        self.solver.time_step = dt
        mu = np.empty(steps)
        for step in range(steps):
            self.surface[:] = np.roll(self.surface, 1)
            self.slope = np.roll(self.slope, 1)
            self.solver.solve(self.load)
            pressure = self.model.traction
            mu[step] = (pressure * self.slope).sum() / pressure.sum()
        return mu


MARCHES: dict[str, type[NumpyMarch] | type[TamaasMarch]]
MARCHES = {"numpy": NumpyMarch, "tamaas": TamaasMarch}
