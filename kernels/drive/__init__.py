"""A slider that is pulled through a spring: the motion of the drive is given, its own is found."""

from .pulled_line import run_pulled
from .slider import PULLED_TRACES, SLIPS
from .spring import Drive

__all__ = ["PULLED_TRACES", "SLIPS", "Drive", "run_pulled"]
