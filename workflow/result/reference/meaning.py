"""What is said of one variable."""

from typing import NamedTuple


class Meaning(NamedTuple):
    """What a reader is told of one variable, in full sentences."""

    text: str  # the formula or the equation of the paper, and how to read it
    sign: str = ""  # where the value may be of either sign: what that says
