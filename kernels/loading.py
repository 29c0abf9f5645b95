"""Machine code of all that a case can need: found in the cache, or compiled by two processes.

    python -m elastomer_friction.kernels.loading SCHEME RATE

compiles the marches (RATE 1 or 0: with the indentation rate or without) and the sums over a line,
while the process that has started it compiles steady sliding, so that both take about as long.
"""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numba.core import event

from .compile.cache import WAITING_EVENT, compile_in_turn
from .compile.garbage import garbage_collection_paused
from .control.printed_eq3 import PrintedForce
from .lines.line import Line
from .lines.self_affine import amplitudes
from .model.force import ConstantForce
from .quick.case import Case, Quantities
from .quick.cases import run_cases
from .quick.contacts.between_samples import slide_between
from .quick.contacts.loads import How
from .quick.contacts.on_lines import slide_on
from .quick.contacts.smooth_line import smooth_line
from .quick.contacts.steady_friction import AtSpeed, Grounds
from .quick.march.active import active_march
from .quick.march.given import March, SteadyState
from .quick.relaxation import Ends, plain_relaxations
from .quick.steady.carry import Decay
from .quick.steady.spans import SPAN, TURN
from .quick.steady.stack import Stack, spans_of_line
from .rheology.forms import form_of
from .rheology.kelvin import SCHEMES
from .rheology.law import State, law_of
from .rheology.spectrum import KELVIN

ROOT = Path(__file__).resolve().parents[1]
STEPS = 4  # per spacing
FEW, MANY = np.array([1]), np.array([4])  # steps: marched plainly, and by lists
WIDE, NARROW = (0.1, 1.0), (1e-3, 100.0)  # load and speed: of wide contacts, and of narrow ones


def load(scheme: str, asked: Quantities) -> None:
    """Compile the kernels, or load them from the cache.

    One process of a machine at a time: the others find what the first one has compiled.
    """
    line = _line()
    cases = [
        Case(*WIDE, (1.2,), (FEW,), scheme),
        Case(*NARROW, (1.2,), (MANY,), scheme),
    ]
    with compile_in_turn(), garbage_collection_paused():  # a sixth of a compiler's time went there
        with _helped(scheme, asked):
            at_speed, nobody = AtSpeed.of(scheme, STEPS, WIDE[1], (1.2,)), np.empty(0)
            how = How(float(STEPS), at_speed.share, True, True)
            speeds = at_speed.speed, at_speed.others
            slide_on(at_speed.law, _stack(line), speeds, nobody, how)
            smooth = smooth_line(line.z, line.slope, 1.0 / STEPS)
            slide_between(smooth, WIDE[1], nobody, nobody, nobody)
            law_of(form_of(KELVIN, scheme), 1.0)  # which says the times of a curve
        run_cases(line, cases, asked)


def load_half(scheme: str, rate: bool) -> None:
    """Compile the half of the other process: of numbers that mean nothing, but have their types."""
    line = _line()
    z, slope = line.z, line.slope
    Grounds.of([line], marched=True)
    law = SCHEMES[scheme](1.0)
    load = WIDE[0] * z.size
    state = State(np.zeros_like(z), WIDE[0] + float(z.mean()))
    stack, sums = _stack(line), np.zeros(z.size // SPAN)
    spans = spans_of_line(stack, 0)
    control = ConstantForce(load) if rate else PrintedForce(load)
    ends = Ends(Decay(*law), sums[None], np.array([state.d]))
    plain_relaxations(stack, law, ends, ends, control, FEW)
    if rate:  # eq. 3 as printed is marched plainly
        steady = SteadyState(Decay(*law), sums, np.zeros(sums.size + 1), state.d)
        march = March(z, slope, spans, law, law, steady, steady, 0.0)
        active_march(march, control, MANY)


def _stack(line: Line) -> Stack:
    """Return a stack of one line of whose spans nothing is known."""
    z = line.z[None]
    row = np.zeros((1, line.z.size // SPAN))
    rows, whole = np.zeros((1, row.size + 1, TURN + 1)), np.zeros((1, 4))
    deepest = np.array([np.argmin(line.z)])
    return Stack(z, line.slope[None], row, row, row, row, rows, whole, deepest)


def _line() -> Line:
    return Line.self_affine(amplitudes(0.5, 512), np.linspace(0.0, 6.0, 256), 512, STEPS)


@contextlib.contextmanager
def _helped(scheme: str, asked: Quantities) -> Iterator[None]:
    """Let another process compile its half as soon as this one compiles anything."""
    command = [sys.executable, "-m", __name__, scheme, str(int(asked.indentation_rate))]
    helpers: list[subprocess.Popen] = []

    class Once(event.Listener):
        def on_start(self, event: Any) -> None:
            """Start it."""
            if not helpers:
                quiet = subprocess.DEVNULL
                helpers.append(subprocess.Popen(command, cwd=ROOT, stdout=quiet, stderr=quiet))

        def on_end(self, event: Any) -> None:
            """Go on."""

    if not asked.relaxation or _cores() == 1:
        yield
        return
    try:
        with event.install_listener("numba:compile", Once()):
            yield
        for helper in helpers:  # none where all was found
            with event.trigger_event(WAITING_EVENT):
                helper.wait()
    finally:
        for helper in helpers:
            helper.kill()
            helper.wait()


def _cores() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


if __name__ == "__main__":
    with garbage_collection_paused():
        load_half(sys.argv[1], sys.argv[2] == "1")
