"""What programmes of motion tell: traces, peaks, healing, loops, energies, rate and state.

Plain arrays in and out; knows of the fits beside it those of eq. 6.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.reduce.scenes.programmes import reduce_programmes, reduce_steps
    from workflow.reduce.scenes.rate_state import LAWS, fit_rate_state, step_law

__all__, __getattr__ = public_names(__name__, __file__)
