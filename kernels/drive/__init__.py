"""A slider that is pulled through a spring: the motion of the drive is given, its own is found."""

from .pulled_line import run_pulled
from .slider import PULLED_TRACES, SLIPS, courses
from .spring import Drive
from .step import TOLERANCE

__all__ = ["PULLED_TRACES", "SLIPS", "TOLERANCE", "Drive", "courses", "run_pulled"]
