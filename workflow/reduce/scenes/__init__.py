"""What programmes of motion tell: traces, peaks, healing, loops, energies, rate and state.

Plain arrays in and out; knows of the fits beside it those of eq. 6.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .programmes import reduce_programmes, reduce_steps
    from .rate_state import LAWS, fit_rate_state, step_law

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
