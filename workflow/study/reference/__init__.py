"""What every key of study.toml means, its unit, and what changes when it is doubled.

Texts alone: values, defaults and ranges are taken from the tables that check the keys.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.study.reference.measures import described_measures
    from workflow.study.reference.schema import study_schema
    from workflow.study.reference.tables import DescribedKey, described_tables
    from workflow.study.reference.text import Text

__all__, __getattr__ = public_names(__name__, __file__)
