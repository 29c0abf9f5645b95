"""The pace of this machine: how much longer than the typical one it takes, by kind and part.

It is measured once (timing.py), then kept, and corrected by what runs took: a run of some kind of
work says more of the next one than any measurement. It is kept in the cache folder of the compiled
kernels, one file per kernels, processor and packages. Predictions and the size of batches depend on
it; no key and no result does.
"""

import contextlib
import hashlib
import json
import math
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from statistics import mean
from typing import Any, NamedTuple

import numba
import numpy as np

from ....kernels import Quantities
from ....kernels.compile import cache
from ....kernels.compile.cache import source_hash
from ...ground import UserError
from ...simulate import load_kernels
from ...system import (
    PROGRAM_ROOT,
    THREADS,
    make_folder,
    processor,
    report_compilation,
    write_durably,
)
from . import timing, work
from .work import PARTS, PLAIN

# Seconds of runs that count as much as the measurement does: runs of the work that was measured,
# on many problems, and runs of any other work.
MEASURED_SECONDS, TOLD_SECONDS = 60.0, 3.0
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
        worth, doubt = TOLD_SECONDS, UNKNOWN
        if kind == PLAIN and self.measured:
            worth, doubt = MEASURED_SECONDS, max(math.log(worst), LAWS)
        share = known.seconds / (known.seconds + worth)
        log = (1.0 - share) * math.log(first) + share * known.log
        scatter = math.sqrt(max(known.square - known.log**2, 0.0))
        return Rate(math.exp(log), math.hypot(LAWS, (1.0 - share) * doubt + share * scatter))


TYPICAL: Pace = Pace()


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


Parted = Mapping[tuple[str, str], float]  # (kind, part) of work -> CPU seconds


class Machine(NamedTuple):
    """A pace, and a note on where it comes from."""

    pace: Pace
    note: str


def pace_file() -> Path:
    """Return where the pace of these kernels on this processor is kept."""
    method = b"".join(Path(str(m.__file__)).read_bytes() for m in (timing, work))
    what = (source_hash(), processor(), np.__version__, numba.__version__, numba.config.DISABLE_JIT)
    name = hashlib.sha256(repr(what).encode() + method).hexdigest()[:16]
    return Path(cache.CACHE_FOLDER) / f"pace-{name}.json"


def known_machine() -> Machine | None:
    """Return the pace of this machine as it was measured before, or None where it was not."""
    data = _kept(pace_file())
    return None if data is None else _machine(data)


def this_machine() -> Machine:
    """Return the pace of this machine, measured now if it is not known yet."""
    if known := known_machine():
        return known
    how = "the numerical core", "20 to 60 s", cache.WAITING_EVENT
    with report_compilation(*how):
        load_kernels("foundation", "exponential", Quantities())
    print("Measuring the speed of this machine, about 3 s, once.", file=sys.stderr)
    data = _parsed(_measured())
    if data is None:
        return Machine(TYPICAL, "another machine, as this one could not be timed")
    found = _machine(data)
    file = pace_file()
    if not _keep(file, data):
        return found._replace(note=f"{found.note}, not kept: {file.parent} is not writable")
    return found


def learn(used: Parted, typical: Parted) -> None:
    """Note what work took here, beside what is typical of it: the next prediction is nearer.

    Where the pace is not kept, nothing is learned.
    """
    file = pace_file()
    data = _kept(file)
    if data is None:
        return
    known = _machine(data).pace.learned
    for (kind, part), seconds in used.items():
        name = label(kind, part)
        after = known.get(name, Learned()).after(seconds, typical.get((kind, part), 0.0))
        data["learned"][name] = list(after)
    _keep(file, data)


def _machine(data: dict[str, Any]) -> Machine:
    measured = {part: tuple(data["measured"][part]) for part in PARTS}
    learned = {name: Learned(*values) for name, values in data["learned"].items()}
    note = f"{data['machine']}, {data['date']}"
    hours = sum(own.seconds for own in learned.values()) / 3600.0
    if hours:
        note += f", and in {hours:.2g} core-hours of runs"
    return Machine(Pace(measured, learned), note)


def _kept(file: Path) -> dict[str, Any] | None:
    """Return what a file holds, or None where it is missing or damaged."""
    with contextlib.suppress(OSError, UnicodeDecodeError):
        return _parsed(file.read_text(encoding="utf-8"))
    return None


def _keep(file: Path, data: dict[str, Any]) -> bool:
    """Write a file; return whether that was possible."""
    try:
        make_folder(file.parent)
        write_durably(file, json.dumps(data).encode())
    except UserError:
        return False
    return True


def _parsed(text: str) -> dict[str, Any] | None:
    """Return what a JSON text says of a machine, or None where it is damaged."""
    try:
        data = json.loads(text)
        data.setdefault("learned", {})
        numbers = [float(x) for part in PARTS for x in data["measured"][part]]
        learned = [Learned(*map(float, values)) for values in data["learned"].values()]
        whole = len(numbers) == 2 * len(PARTS) and all(1e-6 < x < 1e6 for x in numbers)
        sound = all(abs(own.log) < 20.0 and own.square < 400.0 for own in learned)
        timed = all(0.0 <= own.seconds < math.inf for own in learned)
        told = isinstance(data["machine"], str) and isinstance(data["date"], str)
        return data if whole and sound and timed and told else None
    except (AttributeError, ValueError, KeyError, TypeError):
        return None


def _measured() -> str:
    """Return what a process with the settings of a worker measures, "" where it fails."""
    environment = {**os.environ, **THREADS}
    command = [sys.executable, "-m", "elastomer_friction.workflow.plan.cost.timing"]
    done = subprocess.run(
        command, env=environment, cwd=PROGRAM_ROOT, capture_output=True, text=True
    )
    return done.stdout if done.returncode == 0 else ""
