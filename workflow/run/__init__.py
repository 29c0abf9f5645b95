"""The driver of a run: rounds, failures, collection, status and summary.

It computes the missing records, stores them as they finish, reduces them and writes the result.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .block_values import block_dataset
    from .cost_sample import CostSample, sample_cost
    from .grid_run import run_plan
    from .measurement import run_measured
    from .status import read_status, result_line, status_lines
    from .workers import RunOptions

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
