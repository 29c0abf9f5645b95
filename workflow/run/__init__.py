"""The driver of a run: rounds, failures, collection, status and summary.

Computes what is missing, stores it as it finishes, reduces, writes the result.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.run.measured import run_measured
    from elastomer_friction.workflow.run.run import run_plan
    from elastomer_friction.workflow.run.status import read_status, result_line, status_lines
    from elastomer_friction.workflow.run.workers import How

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
