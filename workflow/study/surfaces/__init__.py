"""Surfaces: the table [surface], and the reading and preparation of measured lines.

It depends on the spectra of the kernels and on the settings, and on no later stage.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .profile import Profile, check_load, profile_of_array, rows_of_map
    from .surface import Surface
    from .table import (
        LINE_KIND_KEYS,
        SURFACE,
        check_cutoff,
        lines_like,
        read_measured_surface,
        read_surface,
    )

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
