"""A slider pulled through a spring: its motion follows from that of the drive."""

from .pulled_line import run_pulled
from .pulled_slider import (
    DRIVE_ENERGIES,
    MAX_SLIP_EVENTS,
    PULLED_TRACES,
    SLIP_EVENTS,
    SLIPS,
    drive_legs,
    slider_room,
)
from .slider_step import FORCE_TOLERANCE
from .spring import Drive
