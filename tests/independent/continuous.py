"""Elements that slide continuously in time, by scipy's solve_ivp with contact events.

A few elements under a line of a few modes; nothing is stepped by samples. Touching elements sit
at z - d, free ones decay as exp(-t) exactly, so only d is integrated, from the balance of forces

    sum over touching (d - z_i + v z_i' + dd/dt) = load        (eqs 3 and 4),

and beside it the friction force. An event is an element whose force or gap has vanished.
Units of kernels/__init__.py; the line moves towards +x.
"""

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from tests.references import sorted_root

ACCURACY = 1e-10
SLACK = 1e-12  # a force or gap that far below zero is an event: rounding is none


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
    """The elements at positions x under a moving line, from displacements u and indentation d."""

    def __init__(self, line, x, u, d, load, speed):
        self.line, self.x, self.load, self.speed = line, x, load, speed
        self.u, self.since = u.copy(), np.zeros(u.size)  # of free elements: u when they were freed
        self.time, self.depth, self.work = 0.0, d, 0.0  # work: of friction, per distance
        self.settle(u >= line(x)[0] - d - SLACK)

    def settle(self, near):
        """Let those elements touch that a rate with sum of forces = load presses."""
        z, slope = self.line(self.x - self.speed * self.time)
        pressure = self.depth - z + self.speed * slope
        rate = sorted_root(-pressure[near], self.load)
        self.touching = near & (pressure + rate > SLACK)

    def state(self, time, d):
        """Return heights, slopes, p of all elements were they to touch, and dd/dt."""
        z, slope = self.line(self.x - self.speed * time)
        pressure = d - z + self.speed * slope
        rate = (self.load - pressure[self.touching].sum()) / self.touching.sum()
        return z, slope, pressure + rate, rate

    def derivatives(self, time, y):
        """Return d/dt of (d, integral of the friction force)."""
        _, slope, pressure, rate = self.state(time, y[0])
        return [rate, float(pressure[self.touching] @ slope[self.touching])]

    def margins(self, time, d):
        """Return the force of each touching element and the gap below each free one."""
        z, _, pressure, _ = self.state(time, d)
        return np.where(self.touching, pressure, z - d - self.u * np.exp(self.since - time))

    def advance(self, end):
        """Slide until the time ``end``; return the friction averaged over the way there."""

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
        """Free the element whose force vanished, or let the one touch whose gap closed."""
        i = int(np.argmin(self.margins(self.time, self.depth)))
        before = self.touching
        self.settle(before ^ (np.arange(self.x.size) == i))
        freed = before & ~self.touching
        z, _ = self.line(self.x - self.speed * self.time)
        self.u[freed] = z[freed] - self.depth
        self.since[freed] = self.time
