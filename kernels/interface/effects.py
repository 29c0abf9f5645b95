"""Effects that a scene requests beyond the loss of a deep elastomer at a constant temperature.

A disabled effect is None and costs nothing.
"""

from typing import NamedTuple

from ..heat.heat import Heat
from .layer import Layer
from .shear import ShearLaw


class Effects(NamedTuple):
    """Effects of a case; hashable, because they are part of keys."""

    shear: ShearLaw | None = None
    layer: Layer | None = None  # None: the half-space is deep
    heat: Heat | None = None


NO_EFFECTS = Effects()
