"""Computation of a worker. Stored numbers depend on the code of this room and the kernels alone.

This code is part of the key of every record, and imports nothing else that affects a number.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .code_hash import CODE_HASH
    from .drawing import line_generator
    from .halved_steps import REFINEMENT_FACTOR
    from .layout import CONTACT_LENGTH_EDGES, HALVED_STEP_SCALARS, row_layout, row_width, unpack
    from .programmes import SHAPE_ERROR
    from .realizations import block_means, load_kernels
    from .recorded_steps import (
        curve_times,
        max_leg_counts,
        programme_steps,
        record_steps,
        total_steps,
        trace_size,
        trace_steps,
    )
    from .tasks import (
        PHASES,
        SCALARS,
        Batch,
        BatchResult,
        LineShape,
        Problem,
        Record,
        Recording,
        ScaledHistory,
        Task,
    )

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
