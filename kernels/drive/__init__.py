"""A slider that is pulled through a spring: the motion of the drive is given, its own is found."""

from .pulled import PULLED_TRACES
from .run import run_pulled
from .spring import Drive

__all__ = ["PULLED_TRACES", "Drive", "run_pulled"]
