"""What velocity steps that were measured determine of the kinetic law: read, parted, fitted, drawn.

Text files of a laboratory in; jumps, rates, tau, H, q_max and rate-and-state constants out.
"""

from typing import TYPE_CHECKING

from ..lazy import public_names

if TYPE_CHECKING:
    from .figure import draw_fit
    from .record import read_record
    from .sentences import describe
    from .together import Known, fit_records

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
