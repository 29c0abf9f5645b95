"""Response of friction to a velocity jump: a jump of mu, or of its rate.

With a dashpot, forces follow the velocity at once while displacements are continuous. Without one
the elastomer is glassy at first: forces and friction are continuous and their rates jump.
"""

import numpy as np

from ..lines.line import Line
from ..model.friction import quadrature
from ..rheology.forms import Form
from ..rheology.law import Elements, displacement, law_of, static_pressure
from ..rheology.retardation import Retardation


def friction_jump(form: Form, line: Line, elements: Elements, speed: float, ratio: float) -> float:
    """Return the jump of mu (h/dx) when steady sliding at ``speed`` changes to ``ratio * speed``.

    form : of the material (rheology/forms.py), which must have a dashpot. elements : of steady
    sliding (steady_memory.py). speed : vbar, signed. In contact p = p_0 + eta (v z' + d'), where
    p_0 is the static_pressure. With p_0 in place of d - z this is the quadrature of the Kelvin
    element.
    """
    viscosity, pressure = static_pressure(form, elements.memory)
    law = law_of(form, 1.0 / (line.steps_per_spacing * abs(speed)))
    free = displacement(form, elements.memory, elements.p) + elements.p / law.stiffness
    depth = elements.d - pressure  # height at which a Kelvin element would bear this pressure
    direction, fields = 1 if speed > 0.0 else -1, (depth, line.slope, free + depth - line.z)
    z, slope, w = (np.ascontiguousarray(field[::direction]) for field in fields)
    viscous, load = viscosity * speed, float(elements.p.sum())
    before, _, _ = quadrature(z, slope, w, elements.d, viscous, viscous, load)
    after, _, _ = quadrature(z, slope, w, elements.d, viscous, ratio * viscous, load)
    return after - before


def initial_rate(
    units: Retardation, line: Line, p: np.ndarray, speed: float, ratio: float
) -> float:
    """Return d mu/dt (h/dx per tau) at t0+ after the jump from ``speed`` to ``ratio * speed``.

    p (n,) : forces of steady sliding, in which mu is constant. The rates of the units do not jump.
    A velocity change dv adds dv (z' - mean z')/J_g to the rate of the force of each touching
    element, with the mean over these, and -dv z'' to the rate of its slope. z'' is that of the
    Fourier series. The material must not have a dashpot.
    """
    touching = p > 0.0
    slope = line.slope[touching]
    stiffening = float(np.sum((slope - slope.mean()) ** 2)) / units.glass
    turning = float(np.sum(p * _second_derivative(line)))
    return (ratio - 1.0) * speed * (stiffening - turning) / float(p.sum())


def _second_derivative(line: Line) -> np.ndarray:
    """Return z'' in h/dx^2, shape (n,)."""
    n = line.slope.size
    waves = np.fft.rfft(line.slope) * 2j * np.pi * np.fft.rfftfreq(n) * line.steps_per_spacing
    if n % 2 == 0:
        waves[-1] = 0.0  # the derivative of the shortest cosine vanishes at the samples
    return np.fft.irfft(waves, n)
