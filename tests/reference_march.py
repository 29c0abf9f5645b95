"""Reference march: the paper's equations for every element, in plain numpy, slow.

Every element of the periodic line is moved and solved for at every step, without an active set and
without iterations for d. The line moves in either direction, to test mirror images.
"""

import numpy as np
from scipy.optimize import brentq

from tests.references import sorted_root

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(20)


def constants(scheme: str, dt: float) -> tuple[float, float, float]:
    """Return decay E, stiffness K and lag of one step from the defining formulas.

    implicit-euler: u_new (1 + dt) = u_old - dt f; the slope is that at the end of the step.
    exponential: u_new = e^-dt u_old - int e^-(dt - s) f(s) ds; the force acts at the centre of
    this weight, computed by Gauss quadrature.
    """
    if scheme == "implicit-euler":
        return 1.0 / (1.0 + dt), (1.0 + dt) / dt, 0.0
    before_end = 0.5 * dt * (1.0 + _NODES)
    weight = _WEIGHTS * np.exp(-before_end)
    lag = np.sum(weight * before_end) / np.sum(weight) / dt
    return np.exp(-dt), 1.0 / (1.0 - np.exp(-dt)), float(lag)


def one_element_round_the_line(z, d: float, decay: float, direction: int):
    """Return (u, w) at the samples for an element that passes twice round the line at constant d.

    If the line moves towards +x (``direction`` 1), the element meets samples of decreasing number.
    In one turn the initial state decays by decay^n, or is lost at the deepest sample, in contact.
    """
    u = np.zeros(z.size)
    w = np.zeros(z.size)
    current = 0.0
    for k in range(2 * z.size):
        at = -direction * k % z.size
        w[at] = decay * current
        current = u[at] = min(w[at], z[at] - d)
    return u, w


def steady(z, load: float, decay: float, direction: int = 1):
    """Return (u, w, d) of steady sliding: the d at which mean(-u) = Fbar, by bisection.

    Source: -u = f - du/dt (eq. 2), and the mean of du/dt vanishes in steady sliding.
    """
    low, high = z.min(), sorted_root(z, load * z.size)
    for _ in range(60):
        d = 0.5 * (low + high)
        u, w = one_element_round_the_line(z, d, decay, direction)
        if -u.mean() < load:
            low = d
        else:
            high = d
    return u, w, d


class Elements:
    """The elements of a line, one per sample, marched in time under a constant load."""

    def __init__(self, z, slope, u, d, load, step, direction=1):
        self.z, self.slope, self.u, self.d = z, slope, u.copy(), d
        self.load, self.direction = load, direction
        self.decay, self.stiffness, self.lag = step
        self.at = np.arange(z.size)  # the sample above each element

    def advance(self) -> float:
        """Move the line by one sample, solve for d and return the friction of the step."""
        before = self.slope[self.at]
        self.at = (self.at - self.direction) % self.z.size
        free = self.decay * self.u
        line = self.z[self.at]
        self.d = sorted_root(line - free, self.load * line.size / self.stiffness)
        self.u = np.minimum(free, line - self.d)
        force = self.stiffness * (free - self.u)
        slope = (1.0 - self.lag) * self.slope[self.at] + self.lag * before
        return float(np.sum(force * slope) / np.sum(force))


class RigidElements(Elements):
    """The same with eq. 3 as printed, without the force of the indentation rate.

    The last displacement of an element in contact is taken to be z - d with the new d.
    """

    def free(self, d, line_before, touched):
        """Return displacements after a step without force, with z - d in contact before it."""
        return self.decay * np.where(touched, line_before - d, self.u)

    def advance(self) -> float:
        """Move the line by one sample, find d by bisection and return the friction."""
        before, line_before = self.slope[self.at], self.z[self.at]
        touched = self.u == line_before - self.d
        self.at = (self.at - self.direction) % self.z.size
        line = self.z[self.at]

        def force(d):
            free = self.free(d, line_before, touched)
            return self.stiffness * np.maximum(0.0, free - (line - d))

        self.d = brentq(lambda d: force(d).mean() - self.load, -1.0, 1e3, xtol=1e-15, rtol=1e-15)
        forces = force(self.d)
        self.u = np.minimum(self.free(self.d, line_before, touched), line - self.d)
        slope = (1.0 - self.lag) * self.slope[self.at] + self.lag * before
        return float(np.sum(forces * slope) / np.sum(forces))


def relaxation(elements: Elements, steps: int):
    """Return mu and d after each step, both of shape (steps,)."""
    return np.array([(elements.advance(), elements.d) for _ in range(steps)]).T
