"""Runs of one discretisation on some lines: results per line, and CPU time per line."""

import time
from typing import NamedTuple

import numpy as np

from kernels import Case, Line, Outcome, Quantities, run_case
from workflow.plan import horizon_steps
from workflow.simulate import record_steps, record_times
from workflow.study import Numerics

from .points import RATIO, Point, Surface

NUMERICS = Numerics()


class Method(NamedTuple):
    """A discretisation."""

    scheme: str
    steps: int  # m, samples and time steps per dx


class Runs(NamedTuple):
    """Results of one method at one point; first axis: lines. mu in h/dx, times in tau."""

    mu_1: np.ndarray
    mu_2: np.ndarray
    jump: np.ndarray
    curves: np.ndarray  # shape (lines, samples)
    moments: np.ndarray  # shape (samples,), of the samples
    cpu: np.ndarray  # shape (lines, 3): drawing and sampling, steady states and jump, all


def kept_steps_of(point: Point, elements: int, method: Method) -> tuple[np.ndarray, np.ndarray]:
    """Return the steps at which the workflow records a relaxation, and their moments in tau."""
    march_steps = horizon_steps(point.problem(elements), NUMERICS, method.steps)
    kept_steps = record_steps(march_steps, NUMERICS.curve_samples)
    return kept_steps, record_times(kept_steps, method.steps * point.speed * RATIO, method.scheme)


def run(point: Point, surfaces: list[Surface], method: Method) -> Runs:
    """Run a method on lines as the workflow would, and take the CPU time of each."""
    kept_steps, moments = kept_steps_of(point, surfaces[0].elements, method)
    case = Case(point.load, point.speed, (RATIO,), (kept_steps,), method.scheme)
    outcomes, cpu = [], []
    for surface in surfaces:
        outcome, seconds = _run_one(surface, case, method)
        outcomes.append(outcome)
        cpu.append(seconds)
    return Runs(
        mu_1=np.array([o.mu_1 for o in outcomes]),
        mu_2=np.array([o.mu_2[0] for o in outcomes]),
        jump=np.array([o.jump[0] for o in outcomes]),
        curves=np.array([o.curves[0] for o in outcomes]),
        moments=moments,
        cpu=np.array(cpu),
    )


def _run_one(surface: Surface, case: Case, method: Method) -> tuple[Outcome, tuple]:
    began = time.process_time()
    line = Line.self_affine(*surface, method.steps)
    drawn = time.process_time()
    run_case(line, case, Quantities(relaxation=False))
    steady = time.process_time()
    outcome = run_case(line, case, Quantities())
    done = time.process_time()
    return outcome, (drawn - began, steady - drawn, done - steady)


def seconds(runs: Runs) -> np.ndarray:
    """Return the median CPU seconds per realization: of mu_1 and jump, and of everything."""
    drawn, steady, everything = np.median(runs.cpu, axis=0)
    return np.array([drawn + steady, drawn + everything])
