"""The shear of the real contact in the forces of a step."""

import math

from ..body.step import Forces
from ..interface.shear import ShearLaw, shear_stress


def with_shear(acting: Forces, law: ShearLaw, side: float, speed: float) -> Forces:
    """Return the Forces of a step with the shear in the friction; mu remains viscoelastic.

    side : of the map, in dx. speed : as for ``shear_stress``.
    """
    stress = float(shear_stress(law, speed))
    sheared = math.copysign(stress, speed) if speed else 0.0
    return acting._replace(friction=acting.friction + sheared * side * acting.contact_fraction)


def with_shear_share(acting: Forces, shear: float) -> Forces:
    """Add a known shear to the friction; shear : over the normal force, in h/dx."""
    return acting._replace(friction=acting.friction + acting.normal * shear)


def static_shear(
    acting: Forces, law: ShearLaw, side: float, temperature: float | None = None
) -> float:
    """Return the largest shear force of a contact at rest.

    side : of the map, in dx. temperature : as for ``shear_stress``.
    """
    return float(shear_stress(law, 0.0, temperature)) * side * acting.contact_fraction
