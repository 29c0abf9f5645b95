"""Standard errors by the jackknife, and least squares of many curves at once.

Plain arrays in and out; knows nothing of friction.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .decays import fit_decays
    from .jackknife import (
        errors_needed,
        grouped_means,
        padded,
        replicates,
        significant,
        standard_error,
    )
    from .least_squares import Model, fit_curves

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
