"""What is said of one key."""

from typing import NamedTuple


class Text(NamedTuple):
    """What a reader is told of one key, in full sentences."""

    means: str  # what the key says
    changes: str  # what changes when it is doubled, or where it is no number, with another value
    unit: str = ""
    values: str = ""  # what it may be; empty: as its check says
    default: str = ""  # in words; empty: the value that the table has
