"""The contacts of steady states, listed, and as a state of every sample."""

import pytest

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.contacts.pressed import MovingLine, pressed, room_for_pressed
from elastomer_friction.kernels.quick.contacts.touching import list_touching, room_for_all
from elastomer_friction.kernels.quick.steady.carry import NO_GAPS, carry, decay_of
from elastomer_friction.kernels.quick.steady.contacts import first, room_for
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of
from tests.kernels.quick.steady.given import LINES, LOADS, known, line_of

everywhere = pytest.mark.parametrize(
    "given", [(*point, load) for point in LINES for load in LOADS], ids=str
)


class Listed:
    """Steady sliding on a random line: (w, d) by the plain solver, and its contacts."""

    def __init__(self, hurst, elements, m, speed, load):
        self.line, self.speed, self.load = line_of(hurst, elements, m), speed, load
        z, slope = self.line.z, self.line.slope
        self.law, self.spans, own = known(self.line, speed)
        self.total = load * z.size
        self.state, _ = steady_sliding(self.law, z, self.total)
        room = room_for(slope, speed)
        self.decay = decay_of(self.law)
        *_, pieces = carry(self.decay, z, self.spans, own.stay, self.state.d, room, None, NO_GAPS)
        self.contacts = first(room, pieces)
        self.touching = list_touching(z, slope, self.contacts, room_for_all(z.size))

    def at(self, speed, guess=None):
        """Return what touches, at the moment when the speed has become ``speed``.

        guess : of the indentation and its rate; None: the indentation.
        """
        z, slope = self.line.z, self.line.slope
        press = thresholds_of(z, slope, speed, self.law.stiffness).press
        line = MovingLine(z, slope, self.spans, speed, press)
        guess = self.state.d if guess is None else guess
        return pressed(line, self.touching, guess, room_for_pressed(z.size))
