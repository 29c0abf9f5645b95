"""How fast this machine runs the kernels: measured once (timing.py), then kept.

The timings are kept in the cache folder of the compiled kernels, one file per kernels, processor
and packages. Predictions and the size of batches depend on them, results do not.
"""

import contextlib
import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numba
import numpy as np

from kernels import Quantities, cache
from kernels.cache import source_hash
from workflow.errors import UserError
from workflow.plan.cost import timing
from workflow.plan.cost.work import TYPICAL, SecondsBySize, Timings
from workflow.simulate import load_kernels
from workflow.system import (
    ROOT,
    WORKER_ENVIRONMENT,
    make_folder,
    processor,
    saying_what_compiles,
    write_durably,
)

CURVES = [name for name in Timings._fields if name != "case"]


class Machine(NamedTuple):
    """Timings, and a note on where they come from."""

    timings: Timings
    note: str


def timings_file() -> Path:
    """Return where the timings of these kernels on this processor are kept."""
    method = Path(timing.__file__).read_bytes()
    what = (source_hash(), processor(), np.__version__, numba.__version__, numba.config.DISABLE_JIT)
    name = hashlib.sha256(repr(what).encode() + method).hexdigest()[:16]
    return Path(cache.FOLDER) / f"timings-{name}.json"


def this_machine() -> Machine:
    """Return the timings of this machine, measured now if they are not known yet."""
    file = timings_file()
    found = None
    with contextlib.suppress(OSError, UnicodeDecodeError):
        found = _parsed(file.read_text(encoding="utf-8"))
    if found is None:
        with saying_what_compiles():
            load_kernels("exponential", Quantities())
        print("Measuring the speed of this machine, about 3 s, once.", file=sys.stderr)
        text = _measured()
        found = _parsed(text)
        if found is None:
            return Machine(TYPICAL, "another machine, as this one could not be timed")
        try:
            make_folder(file.parent)
            write_durably(file, text.encode())
        except UserError:
            return found._replace(note=f"{found.note}, not kept: {file.parent} is not writable")
    return found


def _parsed(text: str) -> Machine | None:
    """Return the machine that a JSON text tells of, or None where it is damaged."""
    try:
        data = json.loads(text)
        curves = {name: SecondsBySize(*map(tuple, data["timings"][name])) for name in CURVES}
        case = float(data["timings"]["case"])
        seconds = [case, *(s for curve in curves.values() for s in curve.seconds)]
        whole = all(
            len(c.sizes) == len(c.seconds) > 1 and min(c.sizes) > 0 for c in curves.values()
        )
        if not (whole and all(1e-12 < s < 1e3 for s in seconds)):
            return None
        return Machine(Timings(**curves, case=case), f"{data['machine']}, {data['date']}")
    except (ValueError, KeyError, TypeError):
        return None


def _measured() -> str:
    """Return what a process with the settings of a worker measures, "" where it fails."""
    environment = {**os.environ, **WORKER_ENVIRONMENT}
    command = [sys.executable, "-m", "workflow.plan.cost.timing"]
    done = subprocess.run(command, env=environment, cwd=ROOT, capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else ""
