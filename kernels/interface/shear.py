"""Shear stress of the real contact, over the speed and the temperature.

    friction = viscoelastic friction + tau_f(|v|, T) A,    A : the real contact area,

in the direction of sliding. A speed at T acts as a' |v| at the reference temperature, with
a' = exp(E_a/R (1/T - 1/T_ref)). The bell is

    tau_f = tau_0 exp(-(log10(a' |v|/v_0)/w)^2),    w in decades.

Source: B. Lorenz, Y. R. Oh, S. K. Nam, S. H. Jeon, B. N. J. Persson, J. Chem. Phys. 142, 194701
(2015), doi:10.1063/1.4919221. Shear stresses do not displace the normal contact of an
incompressible half-space on a rigid surface (Dundurs' second constant is zero).
"""

from typing import NamedTuple

import numpy as np


class Bell(NamedTuple):
    """Bell over the logarithm of the speed; stresses in E* (h/dx)^2, speeds in dx/tau."""

    stress: float  # tau_0, the maximum
    velocity: float  # v_0, at the maximum
    width: float  # w, in decades


class ShearTable(NamedTuple):
    """Table over the logarithm of the speed; below the first speed the first stress holds."""

    speeds: tuple[float, ...]  # increasing, in dx/tau; (inf,) for a constant stress
    stresses: tuple[float, ...]  # in E* (h/dx)^2


class ShearLaw(NamedTuple):
    """Law of the shear stress; hashable, because it is part of keys."""

    curve: Bell | ShearTable
    creep_velocity: float = 0.0  # below it the stress is constant, in dx/tau
    activation: float = 0.0  # E_a/R, in K
    reference: float = 1.0  # T_ref, in K: the temperature of the scene


def shear_stress(
    law: ShearLaw, speed: float | np.ndarray, temperature: float | None = None
) -> np.ndarray:
    """Return the shear stress of the real contact, in E* (h/dx)^2, not negative.

    speed : of sliding, in dx/tau, of either sign. temperature : in K; None: the reference. Beyond
    the last row of a table the last stress holds, for attempted steps; see ``check_fastest``.
    """
    reduced = np.maximum(np.abs(speed), law.creep_velocity)
    if temperature is not None:
        reduced = reduced * np.exp(law.activation * (1.0 / temperature - 1.0 / law.reference))
    with np.errstate(divide="ignore"):  # at rest, a bell without a creep velocity vanishes
        logs = np.log10(reduced)
    curve = law.curve
    if isinstance(curve, Bell):
        return curve.stress * np.exp(-(((logs - np.log10(curve.velocity)) / curve.width) ** 2))
    return np.interp(logs, np.log10(curve.speeds), curve.stresses)


def check_fastest(law: ShearLaw, speed: float) -> None:
    """Raise ValueError for a speed (dx/tau) beyond the last row of a table."""
    if isinstance(law.curve, ShearTable) and abs(speed) > law.curve.speeds[-1]:
        raise ValueError(
            f"shear: a speed of {abs(speed):.4g} dx/tau lies beyond the last row of the table, "
            f"{law.curve.speeds[-1]:.4g} dx/tau"
        )
