"""What will be done and at what cost: distinct problems, steps, goals, batches.

Plain data: it computes no realization and opens no store.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.plan.batches import (
        Missing,
        batch_target,
        cut,
        make_batches,
        missing_work,
        total_records,
        total_seconds,
    )
    from elastomer_friction.workflow.plan.cost import (
        TYPICAL,
        WHOLE,
        Pace,
        Prediction,
        known_machine,
        learn,
        prediction,
        this_machine,
    )
    from elastomer_friction.workflow.plan.error_laws import (
        LAWS,
        first_order_rate_error,
        known,
        rate_error,
    )
    from elastomer_friction.workflow.plan.goal import JACKKNIFE_GROUPS, Goal, allowed, most_blocks
    from elastomer_friction.workflow.plan.plan import Plan, make_plan
    from elastomer_friction.workflow.plan.problems import line_slope, speed_ratio
    from elastomer_friction.workflow.plan.resolution import (
        FIRST_ORDER,
        horizon_steps,
        steps_per_spacing,
    )
    from elastomer_friction.workflow.plan.variant import Variant

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
