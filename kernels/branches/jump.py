"""What friction does at the moment of a velocity jump: it jumps, or its rate does.

Behind a dashpot forces follow the velocity at once while displacements stay. Without one the
elastomer is glassy for a moment: forces and friction are continuous, their rates jump.
"""

import numpy as np

from ..lines.line import Line
from ..model.friction import quadrature
from ..rheology.forms import Form
from ..rheology.law import Elements, displacement, law_of, static_pressure
from ..rheology.retardation import Retardation


def friction_jump(form: Form, line: Line, elements: Elements, speed: float, ratio: float) -> float:
    """Return the jump of mu (h/dx) from steady sliding at ``speed`` to ``ratio`` times it.

    form : of the material (rheology/forms.py). elements : of steady sliding (steady_memory.py).
    speed : vbar, signed. In contact p = p_0 + eta (v z' + d') with p_0 from the state alone: with
    it in the place of d - z this is the quadrature of the Kelvin element.
    Raises ValueError for a material without a dashpot.
    """
    viscosity, pressure = static_pressure(form, elements.memory)
    if viscosity == 0.0:
        raise ValueError(
            "material has a finite instantaneous modulus: mu does not jump; ask for peak"
        )
    law = law_of(form, 1.0 / (line.steps_per_spacing * abs(speed)))
    free = displacement(form, elements.memory, elements.p) + elements.p / law.stiffness
    depth = elements.d - pressure  # the height that would take this pressure in a Kelvin element
    way = 1 if speed > 0.0 else -1
    z, slope, w = (
        np.ascontiguousarray(field[::way]) for field in (depth, line.slope, free + depth - line.z)
    )
    viscous, load = viscosity * speed, float(elements.p.sum())
    before, _, _ = quadrature(z, slope, w, elements.d, viscous, viscous, load)
    after, _, _ = quadrature(z, slope, w, elements.d, viscous, ratio * viscous, load)
    return after - before


def initial_rate(
    units: Retardation, line: Line, p: np.ndarray, speed: float, ratio: float
) -> float:
    """Return d mu/dt (h/dx per tau) at t0+ after the jump from ``speed`` to ``ratio`` times it.

    p (n,) : forces. The rates of the units are those of steady sliding, in which mu is constant;
    what the change of velocity dv adds to the rates of the forces is dv (z' - mean z')/J_g over the
    touching elements, and to those of their slopes -dv z''. z'' is that of the Fourier series.
    Raises ValueError for a material with a dashpot, whose friction jumps.
    """
    if units.glass == 0.0:
        raise ValueError("material has a dashpot: mu jumps; ask for jump")
    touching = p > 0.0
    slope = line.slope[touching]
    stiffening = float(np.sum((slope - slope.mean()) ** 2)) / units.glass
    turning = float(np.sum(p * _derivative(line)))
    return (ratio - 1.0) * speed * (stiffening - turning) / float(p.sum())


def _derivative(line: Line) -> np.ndarray:
    """Return z'' in h/dx^2, shape (n,)."""
    n = line.slope.size
    waves = np.fft.rfft(line.slope) * 2j * np.pi * np.fft.rfftfreq(n) * line.steps_per_spacing
    if n % 2 == 0:
        waves[-1] = 0.0  # a sine between the samples: its slope at them is zero
    return np.fft.irfft(waves, n)
