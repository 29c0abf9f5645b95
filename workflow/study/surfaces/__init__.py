"""What the lines are: the table [surface], and files of measured lines read and prepared.

Knows the kernels' spectra and the settings, and no later stage.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .profile import Profile, check_load, map_of_array, profile_of_array
    from .surface import Surface
    from .table import LIKE, SURFACE, check_cutoff, lines_like, read_surface

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
