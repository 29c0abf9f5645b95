"""What a plan costs: how much work it is, and how fast this machine works.

No number of a result depends on it.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.plan.cost.amounts import touchable_share
    from elastomer_friction.workflow.plan.cost.machine import (
        Parted,
        known_machine,
        learn,
        this_machine,
    )
    from elastomer_friction.workflow.plan.cost.pace import (
        TYPICAL,
        WHOLE,
        Pace,
        Prediction,
        prediction,
    )
    from elastomer_friction.workflow.plan.cost.sizes import DRAW
    from elastomer_friction.workflow.plan.cost.work import PARTS, Work, kind_of, typical_seconds

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
