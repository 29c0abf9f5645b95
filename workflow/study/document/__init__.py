"""study.toml as it is written: every key of it checked at every scale, and where it stands.

Knows the tables of keys, and nothing of what they come to together.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .complaints import check_every_key
    from .places import placed

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
