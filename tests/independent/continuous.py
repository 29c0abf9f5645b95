"""Elements that slide continuously in time, by scipy's solve_ivp with contact events.

A few elements are under a line of a few modes; time is not divided into steps of a sample. Touching
elements have u = z - d, and those of free elements decay as exp(-t), so only d is integrated, from

    sum over touching (d - z_i + v z_i' + dd/dt) = load        (eqs 3 and 4),

together with the friction force. An event occurs if the force or the gap of an element vanishes.
Units are those of kernels/__init__.py; the line moves towards +x.
"""

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from tests.references import sorted_root

ACCURACY = 1e-10
SLACK = 1e-12  # a force or gap this far below zero is an event; less is rounding


class Modes(NamedTuple):
    """The line z = sum a cos(k x + phase), of period ``length`` (dx) and with any position."""

    amplitude: np.ndarray
    phase: np.ndarray
    length: float

    def __call__(self, x):
        """Return heights and slopes at x."""
        k = 2.0 * np.pi * np.arange(1, self.amplitude.size + 1) / self.length
        angle = np.multiply.outer(x, k) + self.phase
        return np.cos(angle) @ self.amplitude, -np.sin(angle) @ (self.amplitude * k)


class Sliding:
    """Elements at positions x under a moving line, initially at displacements u, indentation d."""

    def __init__(self, line, x, u, d, load, speed):
        self.line, self.x, self.load, self.speed = line, x, load, speed
        self.u, self.since = u.copy(), np.zeros(u.size)  # u and time at which elements became free
        self.time, self.depth, self.work = 0.0, d, 0.0  # work: time integral of the friction force
        self.settle(u >= line(x)[0] - d - SLACK)

    def settle(self, near):
        """Set the touching elements: those of ``near`` with pressure at the dd/dt by eq. 4."""
        z, slope = self.line(self.x - self.speed * self.time)
        pressure = self.depth - z + self.speed * slope
        rate = sorted_root(-pressure[near], self.load)
        self.touching = near & (pressure + rate > SLACK)

    def state(self, time, d):
        """Return heights, slopes, the pressure of all elements if they touched, and dd/dt."""
        z, slope = self.line(self.x - self.speed * time)
        pressure = d - z + self.speed * slope
        rate = (self.load - pressure[self.touching].sum()) / self.touching.sum()
        return z, slope, pressure + rate, rate

    def derivatives(self, time, y):
        """Return d/dt of (d, integral of the friction force)."""
        _, slope, pressure, rate = self.state(time, y[0])
        return [rate, float(pressure[self.touching] @ slope[self.touching])]

    def margins(self, time, d):
        """Return the force of each touching element, and the gap of each free one."""
        z, _, pressure, _ = self.state(time, d)
        return np.where(self.touching, pressure, z - d - self.u * np.exp(self.since - time))

    def advance(self, end):
        """Slide until the time ``end``; return the friction averaged over this time."""

        def event(time, y):
            return self.margins(time, y[0]).min() + SLACK

        event.terminal, event.direction = True, -1.0
        start, before = self.time, self.work
        accuracy = {"rtol": ACCURACY, "atol": 1e-3 * ACCURACY}
        while self.time < end:
            span, y = (self.time, end), [self.depth, self.work]
            actual = solve_ivp(self.derivatives, span, y, "DOP853", events=event, **accuracy)
            assert actual.success
            self.time = float(actual.t[-1])
            self.depth, self.work = actual.y[:, -1]
            if actual.status == 1:
                self._change()
        return (self.work - before) / (self.load * (end - start))

    def _change(self):
        """Release the element whose force vanished, or add the one whose gap closed."""
        i = int(np.argmin(self.margins(self.time, self.depth)))
        before = self.touching
        self.settle(before ^ (np.arange(self.x.size) == i))
        freed = before & ~self.touching
        z, _ = self.line(self.x - self.speed * self.time)
        self.u[freed] = z[freed] - self.depth
        self.since[freed] = self.time
