"""Compilation of all kernels that a case can need, by two processes in parallel.

``python -m elastomer_friction.kernels.loading SCHEME`` compiles marches, its parent the rest.
"""

import contextlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .compile.cache import CACHE_FOLDER, COMPILER
from .lines.line import Line
from .lines.self_affine import amplitudes
from .model.force import ConstantForce
from .quick.contacts.steady_friction import LineSet
from .quick.march.active import active_march
from .quick.march.problem import JumpProblem, SteadyState
from .quick.relaxation import SteadyEnds, plain_relaxations
from .quick.steady.span_sliding import DecayFactors
from .quick.steady.spans import SPAN
from .rheology.forms import form_of
from .rheology.kelvin import SCHEMES
from .rheology.law import law_of
from .rheology.spectrum import KELVIN
from .velocity_step.case import Case, Quantities
from .velocity_step.cases import run_cases

SOURCE_ROOT = Path(__file__).resolve().parents[1]
PLAIN_STEPS = np.array([1])  # marched without lists
LISTED_STEPS = np.array([4])  # marched by lists
LOAD = 0.1


def load(scheme: str, requested: Quantities) -> None:
    """Compile the kernels, or load them from the cache."""
    wide = Case(LOAD, 1.0, (1.2,), (PLAIN_STEPS,), scheme)
    narrow = Case(1e-3, 100.0, (1.2,), (LISTED_STEPS,), scheme)
    with _helper(scheme, requested):
        law_of(form_of(KELVIN, scheme), 1.0)  # called for the times of a curve
        run_cases(_line(), [wide, narrow], requested)
        if scheme == "implicit-euler":
            run_cases(_line(), [wide._replace(refine=False, stepped=True)], requested)


def load_marches(scheme: str) -> None:
    """Compile the marches, with arguments of the right types and arbitrary values."""
    line, law = _line(), SCHEMES[scheme](1.0)
    line_set = LineSet.of([line], marched=True)
    spans, control = np.zeros(line.z.size // SPAN), ConstantForce(LOAD * line.z.size)
    ends = SteadyEnds(DecayFactors(*law), spans[None], np.array([LOAD]))
    plain_relaxations(line_set.stack, law, ends, ends, control, PLAIN_STEPS)
    steady = SteadyState(DecayFactors(*law), spans, np.zeros(spans.size + 1), LOAD)
    ground = line.z, line.slope, line_set.lines[0].spans
    problem = JumpProblem(*ground, law, law, steady, steady, 0.0)
    active_march(problem, control, LISTED_STEPS)


def _line() -> Line:
    return Line.self_affine(amplitudes(0.5, 512), np.linspace(0.0, 6.0, 256), 512, 4)


@contextlib.contextmanager
def _helper(scheme: str, requested: Quantities) -> Iterator[None]:
    """Compile the marches in a child process, once per cache folder."""
    with contextlib.ExitStack() as stack:
        if requested.relaxation and requested.indentation_rate:  # not eq. 3 as printed
            with contextlib.suppress(OSError):  # already started, or a read-only folder
                Path(CACHE_FOLDER, f"helper-{COMPILER}").touch(exist_ok=False)
                command, quiet = [sys.executable, "-m", __name__, scheme], subprocess.DEVNULL
                helper = subprocess.Popen(command, cwd=SOURCE_ROOT, stdout=quiet, stderr=quiet)
                stack.enter_context(helper)
                stack.callback(helper.kill)  # this process has loaded all that it needs
        yield


if __name__ == "__main__":
    load_marches(sys.argv[1])
