"""What a plan costs: how much work it is, and how fast this machine works.

No number of a result depends on it.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .machine import (
        TYPICAL,
        WHOLE,
        Pace,
        Prediction,
        known_machine,
        learn,
        prediction,
        this_machine,
    )
    from .work import PARTS, Work, drawing_seconds, kind_of, touchable_share, typical_seconds

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
