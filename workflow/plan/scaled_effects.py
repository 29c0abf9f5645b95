"""Effects of a scene in the dimensionless units of the kernels, and their limits."""

import math

from ...kernels import (
    GAS_CONSTANT,
    ZERO_CELSIUS,
    Arrhenius,
    Bell,
    Effects,
    Heat,
    ShearLaw,
    ShearTable,
    ShiftTable,
    programme_extent,
)
from ..ground import UserError
from ..simulate import Problem
from ..study import HeatProperties, Material, SceneEffects, Shear
from .motion import Scale, rounded


def scaled_effects(
    effects: SceneEffects, material: Material, scale: Scale, others: Effects
) -> Effects:
    """Return ``others`` with the effects of a scene added, in units of the kernels."""
    shear, heat = effects.shear, effects.heat
    return others._replace(
        shear=shear and _shear_law(shear, material, scale),
        heat=heat and _heat(heat, material, scale),
    )


def _heat(heat: HeatProperties, material: Material, scale: Scale) -> Heat:
    """Return the heating of a scene that starts at the temperature of the material."""
    law, temperature = material.shift_law, material.temperature
    assert law is not None
    assert temperature is not None
    if isinstance(law, ShiftTable):
        law = law._replace(description="")
    flux_unit = material.contact_modulus * scale.roughness**2 / scale.tau  # times dx, W/m
    diffusivity = heat.conductivity / heat.heat_capacity
    return Heat(
        rounded(heat.share * flux_unit / heat.conductivity),
        rounded(diffusivity * scale.tau / scale.spacing**2),
        rounded((heat.block or 0.0) / scale.spacing),
        law,
        temperature,
        rounded(scale.spacing / scale.tau),
    )


def _shear_law(shear: Shear, material: Material, scale: Scale) -> ShearLaw:
    """Return the law of the shear stress, with the temperature of the material as reference."""
    stress_unit = material.contact_modulus * (scale.roughness / scale.spacing) ** 2
    speed_unit, activation, reference = scale.spacing / scale.tau, 0.0, 1.0
    curve_speed_unit = speed_unit  # of the speeds of the curve
    if shear.activation_energy is not None and shear.reference is not None:
        assert material.temperature is not None
        shift = Arrhenius(shear.activation_energy, shear.reference)
        curve_speed_unit *= 10.0 ** shift.decades(material.temperature)
        activation = shear.activation_energy / GAS_CONSTANT
        reference = material.temperature + ZERO_CELSIUS
    curve: Bell | ShearTable
    if shear.rows:
        speeds, stresses = zip(*shear.rows, strict=True)
        curve = ShearTable(
            tuple(rounded(speed / curve_speed_unit) for speed in speeds),
            tuple(rounded(stress / stress_unit) for stress in stresses),
        )
    elif shear.velocity is None or shear.width is None:
        curve = ShearTable((math.inf,), (rounded((shear.stress or 0.0) / stress_unit),))
    else:
        maximum = rounded((shear.stress or 0.0) / stress_unit)
        curve = Bell(maximum, rounded(shear.velocity / curve_speed_unit), shear.width)
    creep = rounded((shear.creep_velocity or 0.0) / speed_unit)
    return ShearLaw(curve, creep, activation, reference)


def check_shear_range(where: str, problem: Problem) -> None:
    """Raise UserError if a motion is faster than the last row of a table of the shear stress."""
    law = problem.effects.shear
    if law is None or not isinstance(law.curve, ShearTable):
        return
    fastest = programme_extent(problem.programme)[1]
    speeds = abs(problem.speed), abs(problem.speed * problem.ratio), fastest
    excess = max(speeds) / law.curve.speeds[-1]
    if excess > 1.0 + 1e-9:
        raise UserError(
            f"{where}.shear.file: its last velocity lies below that of the motion, which is "
            f"{excess:.3g} times as fast; add rows, or slide more slowly"
        )
