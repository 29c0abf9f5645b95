"""What velocity steps that were measured determine of the kinetic law: read, parted, fitted, drawn.

Text files of a laboratory in; jumps, rates, tau, H, q_max and rate-and-state constants out.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.laboratory.figure import draw_fit
    from workflow.laboratory.fit import Fit, fit_records
    from workflow.laboratory.record import TIMES, VELOCITIES, Record, read_record
    from workflow.laboratory.speeds import Known
    from workflow.laboratory.words import describe

__all__, __getattr__ = public_names(__name__, __file__)
