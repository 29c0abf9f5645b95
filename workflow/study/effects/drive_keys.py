"""The table [scene.drive]: the spring, damper and mass through which the line is pulled."""

from functools import partial
from typing import NamedTuple

from ..settings import Key, one_or_several, positive, within


class Spring(NamedTuple):
    """What a slider is pulled through."""

    stiffness: float  # N/m
    mass: float = 0.0  # kg, of the slider
    damping: float = 0.0  # N s/m, beside the spring


MOST = 1e12  # of a mass and a damper: beyond them nothing moves

DRIVE = {
    "stiffness": Key(
        partial(one_or_several, positive),
        "The stiffness k of the spring between the drive and the line. A list makes it a "
        "dimension of the result.",
        "Doubled, the line follows the drive more closely; below a critical stiffness it sticks "
        "and slips where friction falls with the velocity.",
        "N/m",
    ),
    "mass": Key(
        partial(within, least=0.0, most=MOST),
        "The mass of the slider.",
        "Doubled, the slider comes free and stops more slowly.",
        "kg",
        default=0.0,
    ),
    "damping": Key(
        partial(within, least=0.0, most=MOST),
        "The constant c of a damper beside the spring, whose force is c (dY/dt − dX/dt).",
        "Doubled, the drive holds the slider back twice as strongly where it runs ahead.",
        "N s/m",
        default=0.0,
    ),
}
