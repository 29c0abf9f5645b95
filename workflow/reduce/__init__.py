"""Reduction of block means to estimates: jackknife, fits, and the accuracy reached.

The functions take and return plain arrays and run on the workers.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .attainment import (
        ACCURACY_MEANINGS,
        MET_WHERE_DEFINED,
        MISSED,
        Attained,
        attained,
        with_measured_bias,
    )
    from .blocks import Estimates, blocks_of, reduction_of
    from .complete import completed, exponents_of
    from .estimates import reduce_blocks
    from .fits import (
        FITTED,
        NO_RELAXATION,
        NO_STATE,
        NOT_EXPONENTIAL,
        STATUS_COMMENT,
        STATUS_MEANINGS,
        UNDETERMINED,
        fit_exponential,
        fit_relaxation,
    )
    from .jackknife import grouped_means, replicates, standard_error
    from .model_ratio import MAX_THEORY_TASKS, theory_applies
    from .models import EXPONENTIAL, MODEL_MEANINGS, STRETCHED, TWO_EXPONENTIALS
    from .persson_estimates import persson_values
    from .point_quantities import GridPoints, carried_estimates, quantities_of_points
    from .portions import BlockPlace, Portion, StoredBlocks, reduce_portion
    from .rate_state import STATE_LAWS, state_change, step_law
    from .resolution import (
        LARGE_BIAS,
        NARROW_CONTACTS,
        RESOLUTION_COMMENT,
        RESOLUTION_MEANINGS,
        RESOLVED,
        RESOLVED_SAMPLES,
        UNRESOLVED,
    )

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
