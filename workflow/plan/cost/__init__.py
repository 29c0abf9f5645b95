"""What a plan costs: how much work it is, and how fast this machine works.

No number of a result depends on it.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.plan.cost.machine import this_machine
    from workflow.plan.cost.work import TYPICAL, Timings, Work, touchable_share, work_seconds

__all__, __getattr__ = public_names(__name__, __file__)
