"""What every variable of a result means: its formula, its sign, and when it is there.

Texts alone: units, dimensions and flags are taken from the declarations.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .of_tables import SECTIONS

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
