"""Scenes from Python: one point of the grid, computed in the calling process.

``run`` takes the keys of a study as arguments, and uses no cluster, files or store.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from ..report import animate
    from .call import compute, run

__all__, __getattr__, __dir__ = public_names(__name__, __file__, ("animate", "run"))
