"""Kinetics of the friction coefficient of elastomers: what is asked of it from Python.

``scene.run`` computes one scene, ``open`` reads a result file, ``law.fit`` makes a reduced law of
either, ``KineticLaw`` is the closed form of the paper (eqs. 12 to 16), and ``UserError`` is what
all of them raise for input that is not right.
Source: Li, Dimaki, Popov, Psakhie, Popov (2014), doi:10.1038/srep05795.
"""

import os

# We write no file that has its name already, so HDF5 needs no locks of its own; where a file system
# has none, it would refuse to write. HDF5 looks here once, when it is loaded.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")

from typing import TYPE_CHECKING

from elastomer_friction.workflow.ground import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow import law, scene
    from elastomer_friction.workflow.ground import UserError
    from elastomer_friction.workflow.kinetic_law import KineticLaw
    from elastomer_friction.workflow.result import open_tree as open
    from elastomer_friction.workflow.system import VERSION as __version__

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
