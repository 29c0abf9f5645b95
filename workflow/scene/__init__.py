"""A scene from Python: one point of the grid, computed in the calling process.

``run`` takes what a study says as arguments; no dask, no files, no store.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.report import animate
    from elastomer_friction.workflow.scene.alone import computed
    from elastomer_friction.workflow.scene.call import run

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
