"""A slider that is pulled through a spring: the motion of the drive is given, its own is found."""

from .pulled_line import run_pulled
from .slider import MOST_EVENTS, PULLED_TRACES, SLIP_EVENTS, SLIPS, courses
from .spring import Drive
from .step import TOLERANCE

__all__ = [
    "MOST_EVENTS",
    "PULLED_TRACES",
    "SLIPS",
    "SLIP_EVENTS",
    "TOLERANCE",
    "Drive",
    "courses",
    "run_pulled",
]
