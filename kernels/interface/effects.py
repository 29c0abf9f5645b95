"""Effects that a scene requests beyond the loss of the elastomer at a constant temperature.

A disabled effect is None and costs nothing.
"""

from typing import NamedTuple

from .shear import ShearLaw


class Effects(NamedTuple):
    """Effects of a case; hashable, because they are part of keys."""

    shear: ShearLaw | None = None


NO_EFFECTS = Effects()
