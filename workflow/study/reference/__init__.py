"""What every key of study.toml means, its unit, and what changes when it is doubled.

Texts alone: values, defaults and ranges are taken from the tables that check the keys.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .measures import described_measures
    from .schema import study_schema
    from .tables import DescribedKey, described_tables
    from .text import Text

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
