"""Kinetics of the friction coefficient of elastomers: the Python interface.

``scene.run`` computes one scene; ``plan``, ``run`` and ``figure`` are the commands for a study;
``open`` reads a result file and ``block_means`` the means of its blocks; ``prony`` fits a material
to measured moduli; ``law.fit`` fits a reduced law to a scene or a result; ``KineticLaw``
is the closed form of the paper (eqs. 12 to 16). All of them raise ``UserError`` for invalid input.
Source: Li, Dimaki, Popov, Psakhie, Popov (2014), doi:10.1038/srep05795.
"""

import os

# Files are written under temporary names, so that HDF5 needs no locks; without locks of the file
# system it would refuse to write. HDF5 reads this variable once, when it is loaded.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")

from typing import TYPE_CHECKING

from elastomer_friction.workflow.ground import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow import law, scene
    from elastomer_friction.workflow.cli import draw_study as figure
    from elastomer_friction.workflow.cli import fit_moduli as prony
    from elastomer_friction.workflow.cli import plan_study as plan
    from elastomer_friction.workflow.cli import read_block_means as block_means
    from elastomer_friction.workflow.cli import run_study as run
    from elastomer_friction.workflow.ground import UserError
    from elastomer_friction.workflow.kinetic_law import KineticLaw
    from elastomer_friction.workflow.result import open_tree as open
    from elastomer_friction.workflow.system import VERSION as __version__

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
