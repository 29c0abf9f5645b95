"""From block means to estimates: jackknife, fits, and whether an accuracy is met.

Plain arrays in and out; runs on the workers.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.reduce.attainment import (
        ACCURACY_MEANINGS,
        MET_WHERE_DEFINED,
        MISSED,
        Attained,
        attained,
    )
    from elastomer_friction.workflow.reduce.blocks import Blocks, Estimates, blocks_of
    from elastomer_friction.workflow.reduce.complete import completed, exponents_of
    from elastomer_friction.workflow.reduce.estimates import reduce_blocks
    from elastomer_friction.workflow.reduce.exponents import fit_exponents, fit_power_law
    from elastomer_friction.workflow.reduce.fits import (
        FITTED,
        NEGLIGIBLE,
        NO_RELAXATION,
        NO_STATE,
        NOT_EXPONENTIAL,
        STATUS_COMMENT,
        STATUS_MEANINGS,
        UNDETERMINED,
        fit_exponential,
        fit_relaxation,
    )
    from elastomer_friction.workflow.reduce.models import (
        EXPONENTIAL,
        MODEL_MEANINGS,
        STRETCHED,
        TWO_EXPONENTIALS,
        compare_models,
    )
    from elastomer_friction.workflow.reduce.prony_fit import PronyFit, fit_prony
    from elastomer_friction.workflow.reduce.resolution import (
        RESOLUTION_COMMENT,
        RESOLUTION_MEANINGS,
        RESOLVED,
        UNRESOLVED,
    )
    from elastomer_friction.workflow.reduce.scenes import LAWS, fit_rate_state, step_law
    from elastomer_friction.workflow.reduce.statistics import (
        grouped_means,
        replicates,
        significant,
        standard_error,
    )

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
