"""What of the store is reduced: block means of some tasks, and what they belong to."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...kernels import ENERGIES, Programme
from ...kernels.drive import PULLED_TRACES
from ..plan import Plan, Variant, line_slope
from ..simulate import (
    Task,
    curve_steps,
    curve_times,
    programme_steps,
    row_layout,
    trace_steps,
    unpack,
)
from .jackknife import standard_error

Estimates = dict[str, np.ndarray]


class Blocks(NamedTuple):
    """Block means of some tasks, dimensionless, and what is needed to reduce them."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS))
    values: dict[str, np.ndarray]  # parts of a row (layout.py), each (tasks, blocks, *its shape)
    time: np.ndarray  # of the curves, shape (tasks, samples - 1), in tau; NaN beyond the last
    rms_slope: np.ndarray  # shape (tasks,), in h/dx
    quantities: tuple[str, ...]
    jumps: bool = True  # whether friction jumps with the velocity: whether there is a dashpot
    speeds: np.ndarray = np.empty((0, 2))  # before and after the velocity step, dx/tau, (tasks, 2)
    programmes: tuple[Programme, ...] = ()  # of the tasks
    legs: np.ndarray = np.empty((0, 0))  # of the samples of traces, NaN beyond, (tasks, events)
    negligible: float = 0.0  # share of the jump


def columns(fits: Sequence[Any]) -> Any:
    """Return named tuples as one, each of whose fields is the array of it over all of them."""
    return type(fits[0])(*map(np.array, zip(*fits, strict=True)))


def enter(estimates: Estimates, name: str, values: np.ndarray) -> None:
    """Enter an estimate and its standard error from replicates along axis 1."""
    estimates[name] = values[:, 0]
    estimates[f"{name}_error"] = standard_error(values, 1)


def blocks_of(
    plan: Plan, variant: Variant, tasks: list[Task], scalars: np.ndarray, rows: np.ndarray
) -> Blocks:
    """Return some tasks of a variant as they are reduced.

    scalars : shape (tasks, blocks, len(SCALARS)). rows : (tasks, blocks, width), as laid out by
    simulate/layout.py. What differs in length between tasks is filled up with NaN.
    """
    how = plan.quantities, variant.numerics.scheme, variant.recording
    parts = [unpack(own, row_layout(t, *how)) for own, t in zip(rows, tasks, strict=True)]
    traces = {name for name in parts[0] if name in (*PULLED_TRACES, *ENERGIES)}
    values = {
        name: np.stack([_filled(p[name], variant.events if name in traces else 0) for p in parts])
        for name in parts[0]
    }
    speeds = [(t.problem.speed, t.problem.speed * t.problem.ratio) for t in tasks]
    slopes = [line_slope(t.problem, variant.lines.normalisation) for t in tasks]
    return Blocks(
        scalars,
        values,
        _times(plan, variant, tasks),
        np.array(slopes),
        plan.study.scene.quantities,
        variant.material.jumps,
        np.array(speeds),
        tuple(task.problem.programme for task in tasks),
        _legs(variant, tasks),
        variant.numerics.negligible,
    )


def _filled(values: np.ndarray, length: int) -> np.ndarray:
    """Return values with NaN after the last along the last axis, up to a length."""
    ends = [(0, 0)] * (values.ndim - 1) + [(0, max(length - values.shape[-1], 0))]
    return np.pad(values, ends, constant_values=np.nan) if ends[-1][1] else values


def _legs(variant: Variant, tasks: list[Task]) -> np.ndarray:
    """Return the numbers of the legs in which traces are kept, shape (tasks, events)."""
    legs = np.full((len(tasks), variant.events), np.nan)
    for row, task in enumerate(tasks) if variant.events else ():
        what = task.problem, task.steps_per_spacing
        kept = trace_steps(*what, variant.recording)
        steps = programme_steps(*what, variant.recording.origin)
        legs[row, : kept.size] = steps.leg[np.maximum(kept - 1, 0)]
    return legs


def _times(plan: Plan, variant: Variant, tasks: list[Task]) -> np.ndarray:
    """Return the times of the curves after the velocity step, shape (tasks, samples - 1)."""
    samples, scheme = variant.numerics.curve_samples, variant.numerics.scheme
    time = np.full((len(tasks), samples - 1), np.nan)
    for row, task in enumerate(tasks) if plan.quantities.relaxation else ():
        steps_per_tau = abs(task.problem.speed * task.problem.ratio) * task.steps_per_spacing
        kept = curve_steps(task.march_steps, samples, task.problem.spectrum)
        time[row, : kept.size] = curve_times(kept, steps_per_tau, scheme, task.problem.spectrum)
    return time
