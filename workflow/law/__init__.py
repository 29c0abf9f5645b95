"""Reduced laws of friction with their range and error: fit, step, compare and export.

A law represents the simulated friction in models of other programs.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .law_export import FORMS, Exported
    from .law_export import export_law as export
    from .law_fit import fit_law as fit
    from .load_law import LoadLaw
    from .memory_law import MemoryLaw
    from .reduced_law import Law
    from .transients import Transient, transients_of
    from .usual_laws import LuGreLaw, RateStateLaw
    from .usual_laws import read_law as read

__all__, __getattr__, __dir__ = public_names(__name__, __file__, ("Law", "export", "fit", "read"))
