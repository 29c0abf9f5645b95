"""Plan of a run and its cost: distinct problems, steps, goals, batches.

A plan is plain data: it computes no realization and opens no store.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .batches import (
        Missing,
        batch_of,
        batch_target,
        cut,
        make_batches,
        missing_work,
        total_records,
        total_seconds,
    )
    from .choices import MapChoice, map_choices
    from .cost import COST_FACTOR
    from .error_laws import shape_error, stepped_error
    from .error_prediction import discretisation_error, predicted_errors
    from .goal import (
        BIAS,
        FIRST_ORDER,
        JACKKNIFE_GROUPS,
        Goal,
        allowed,
        horizon_steps,
        most_blocks,
        steps_per_spacing,
    )
    from .half_space import equivalent_steps, map_error
    from .other_body import MODEL_LABEL
    from .plan import Plan, make_plan
    from .problems import line_slope, nominal_pressure, speed_ratio
    from .repeated_contact import remembered_share
    from .variant import Variant

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
