"""What velocity steps that were measured determine of the kinetic law: read, parted, fitted, drawn.

Text files of a laboratory in; jumps, rates, tau, H, q_max and rate-and-state constants out.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.laboratory.figure import draw_fit
    from elastomer_friction.workflow.laboratory.fit import Fit, fit_records
    from elastomer_friction.workflow.laboratory.record import TIMES, VELOCITIES, Record, read_record
    from elastomer_friction.workflow.laboratory.speeds import Known
    from elastomer_friction.workflow.laboratory.words import describe

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
