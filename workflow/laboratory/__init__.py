"""Fits to measurements: velocity steps, master curves of sweeps, spectra of surfaces.

They determine jumps, rates, tau, H, q_max, rate-and-state constants, shifts and roll-offs.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .figure import figure_of_fit
    from .fitted_material import FORMS, describe_material, fit_material
    from .master import MasterCurve, Shifting, master_curve
    from .measured_spectrum import spectrum_of
    from .prony_figure import figure_of_moduli
    from .prony_fit import PronyFit
    from .record import read_record
    from .rolloff_fit import fit_rolloff
    from .sentences import describe
    from .spectrum_figure import figure_of_spectrum
    from .spectrum_table import describe_spectrum, spectrum_rows
    from .together import Known, fit_records

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
