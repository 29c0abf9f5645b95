"""Fits to measurements: the kinetic law from velocity steps, master curves from sweeps.

They determine jumps, rates, tau, H, q_max, rate-and-state constants and shifts from text files.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .figure import draw_fit
    from .fitted_material import FORMS, describe_material, fit_material
    from .master import Shifting, master_curve
    from .record import read_record
    from .sentences import describe
    from .together import Known, fit_records

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
