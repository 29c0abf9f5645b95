"""The pace of a machine: how much longer it takes than the typical one, by kind and part of work.

It is measured once (timing.py), and corrected by what runs took: a run of some kind of work says
more of the next one than any measurement. No key, no number of lines and no result depends on it.
"""

import math
from collections.abc import Mapping
from statistics import mean
from typing import NamedTuple

from .work import PLAIN

MEASURED_SECONDS = 3.0  # of runs that a measurement is worth
MOST_SECONDS = 3600.0  # of runs that are remembered: what is longer ago fades
LEAST_SECONDS = 0.2  # of a part of a run, below which it teaches nothing
WHOLE = "whole"  # the part of work that is not told apart: that of a study that measures
UNKNOWN = 0.35  # spread of the logarithm of used over predicted, where nothing is known
LAWS = 0.10  # of it, that the laws leave where much is known
SPREADS = 1.3  # to either side of an interval: nine of ten


class Learned(NamedTuple):
    """What runs of one kind took in one part."""

    seconds: float = 0.0  # CPU time that it rests on, at most MOST_SECONDS
    log: float = 0.0  # mean of log(used / typical), weighted by the time
    square: float = 0.0  # mean of its square

    def after(self, used: float, typical: float) -> "Learned":
        """Return what is known after a run that used so much instead of the typical time."""
        if min(used, typical) < LEAST_SECONDS:
            return self
        log, now = math.log(used / typical), min(used, MOST_SECONDS)
        share = now / (now + min(self.seconds, MOST_SECONDS - now))
        return Learned(
            min(self.seconds + now, MOST_SECONDS),
            (1.0 - share) * self.log + share * log,
            (1.0 - share) * self.square + share * log**2,
        )


class Rate(NamedTuple):
    """How much longer than typical something takes."""

    factor: float
    spread: float  # of the logarithm of used over predicted


class Pace(NamedTuple):
    """The pace of a machine."""

    measured: Mapping[str, tuple[float, float]] = {}  # part -> factor, largest over smallest
    learned: Mapping[str, Learned] = {}  # by ``label``

    def rate(self, kind: str, part: str) -> Rate:
        """Return how much longer than typical a part of some kind of work takes.

        Until it was run, the measured part tells of work of its own kind alone: what is known of
        other code is how quick the machine is in the mean of all parts.
        """
        first, worst = self.measured.get(part, (1.0, 1.0))
        if kind != PLAIN and self.measured:
            first = math.exp(mean(math.log(factor) for factor, _ in self.measured.values()))
        known = self.learned.get(label(kind, part), Learned())
        share = known.seconds / (known.seconds + MEASURED_SECONDS)
        log = (1.0 - share) * math.log(first) + share * known.log
        doubt = UNKNOWN if kind != PLAIN or not self.measured else max(math.log(worst), LAWS)
        scatter = math.sqrt(max(known.square - known.log**2, 0.0))
        return Rate(math.exp(log), math.hypot(LAWS, (1.0 - share) * doubt + share * scatter))


TYPICAL = Pace()


def label(kind: str, part: str) -> str:
    """Return the name of a part of some kind of work."""
    return f"{kind} {part}"


class Prediction(NamedTuple):
    """CPU seconds as they are expected, and between which nine of ten runs end."""

    seconds: float
    low: float
    high: float


def prediction(pace: Pace, typical: Mapping[tuple[str, str], float]) -> Prediction:
    """Return the prediction for so many typical seconds of each (kind, part).

    Parts err together within a kind of work and each for itself otherwise.
    """
    rates = {which: pace.rate(*which) for which in typical}
    seconds = sum(rates[which].factor * typical[which] for which in typical)
    variance = sum((rates[w].spread * rates[w].factor * typical[w]) ** 2 for w in typical)
    width = math.exp(SPREADS * math.sqrt(variance) / seconds) if seconds else 1.0
    return Prediction(seconds, seconds / width, seconds * width)
