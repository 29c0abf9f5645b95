"""Block means of tasks and the settings needed to reduce them."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...kernels import ENERGIES, Programme, Quantities
from ...kernels.drive import DRIVE_ENERGIES, PULLED_TRACES
from ...kernels.half_space.heated_map import TEMPERATURE_TRACES
from ...kernels.motion.legs import leg_duration
from ..plan import Variant, line_slope
from ..simulate import (
    Recording,
    Task,
    curve_times,
    programme_steps,
    record_steps,
    row_layout,
    trace_steps,
    unpack,
)
from ..study import Numerics
from .jackknife import standard_error
from .point_quantities import carried_estimates
from .shear_sums import Parts, add_shear

TRACE_ESTIMATES = (*PULLED_TRACES, *TEMPERATURE_TRACES)
PROGRAMME_TRACES = (*TRACE_ESTIMATES, *ENERGIES, *DRIVE_ENERGIES)
Estimates = dict[str, np.ndarray]


class Blocks(NamedTuple):
    """Dimensionless block means of tasks, and the settings needed to reduce them."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS))
    values: dict[str, np.ndarray]  # parts of a row (layout.py), each (tasks, blocks, *its shape)
    time: np.ndarray  # of the curves, shape (tasks, samples - 1), in tau; NaN beyond the last
    rms_slope: np.ndarray  # shape (tasks,), in h/dx
    quantities: tuple[str, ...]
    jumps: bool = True  # friction jumps with the velocity: the material has a dashpot
    speeds: np.ndarray = np.empty((0, 2))  # before and after the velocity step, dx/tau, (tasks, 2)
    programmes: tuple[Programme, ...] = ()  # of the tasks
    legs: np.ndarray = np.empty((0, 0))  # of the trace samples, NaN after the last, (tasks, events)
    negligible: float = 0.0  # largest negligible relaxation over the jump
    carried: tuple[str, ...] = ()  # scalars whose replicates enter the estimates
    parts: Parts | None = None  # of totals, by names such as mu_1_shear; None without shear


class Reduction(NamedTuple):
    """Settings by which block means of a variant are reduced."""

    kernel_quantities: Quantities
    quantities: tuple[str, ...]
    numerics: Numerics
    recording: Recording
    events: int  # samples of the longest trace
    normalisation: str  # of the lines
    jumps: bool  # friction jumps with the velocity
    carried: tuple[str, ...] = ()  # scalars whose replicates the quantities of a point need
    copies: int = 1  # of the measured map per side of a period: 2 if mirrored


def reduction_of(variant: Variant) -> Reduction:
    """Return the settings by which block means of a variant are reduced."""
    return Reduction(
        variant.quantities,
        variant.study.scene.quantities,
        variant.numerics,
        variant.recording,
        variant.events,
        variant.lines.normalisation,
        variant.material.jumps,
        carried_estimates(variant.study.scene.quantities, variant.lines.body),
        round(variant.lines.copies),
    )


def columns(fits: Sequence[Any]) -> Any:
    """Return a named tuple whose fields are arrays over the given named tuples."""
    return type(fits[0])(*map(np.array, zip(*fits, strict=True)))


def enter(estimates: Estimates, name: str, values: np.ndarray) -> None:
    """Store an estimate and its standard error, from replicates along axis 1."""
    estimates[name] = values[:, 0]
    estimates[f"{name}_error"] = standard_error(values, 1)


def blocks_of(
    settings: Reduction, tasks: list[Task], scalars: np.ndarray, rows: np.ndarray
) -> Blocks:
    """Return the block means of tasks, ready to be reduced.

    scalars : shape (tasks, blocks, len(SCALARS)). rows : (tasks, blocks, width), in the layout of
    simulate/layout.py. Arrays that differ in length between tasks are padded with NaN.
    """
    layout = settings.kernel_quantities, settings.numerics.scheme, settings.recording
    parts = [unpack(row, row_layout(t, *layout)) for row, t in zip(rows, tasks, strict=True)]
    traces = {name for name in parts[0] if name in PROGRAMME_TRACES}
    values = {
        name: np.stack([_filled(p[name], settings.events if name in traces else 0) for p in parts])
        for name in parts[0]
    }
    if "tiles" in values and settings.copies > 1:
        values["tiles"] = _folded(values["tiles"])
    of_slider = settings.recording.one_slider and settings.recording.every
    legs = _legs_at(tasks, values["trace_time"]) if of_slider else _legs(settings, tasks)
    scalars, values, shear_parts = add_shear(tasks, scalars, values, legs)
    speeds = [(t.problem.speed, t.problem.speed * t.problem.ratio) for t in tasks]
    slopes = [line_slope(t.problem, settings.normalisation) for t in tasks]
    return Blocks(
        scalars,
        values,
        _times(settings, tasks),
        np.array(slopes),
        settings.quantities,
        settings.jumps,
        np.array(speeds),
        tuple(task.problem.programme for task in tasks),
        legs,
        settings.numerics.negligible,
        settings.carried,
        shear_parts or None,
    )


def _folded(sums: np.ndarray) -> np.ndarray:
    """Add the sums (..., tiles, tiles) of mirrored tiles, which are not independent."""
    for axis in (-2, -1):
        sums = np.split(sums + np.flip(sums, axis), 2, axis)[0]
    return sums


def _filled(values: np.ndarray, length: int) -> np.ndarray:
    """Return values padded with NaN along the last axis, to a length of at least ``length``."""
    ends = [(0, 0)] * (values.ndim - 1) + [(0, max(length - values.shape[-1], 0))]
    return np.pad(values, ends, constant_values=np.nan) if ends[-1][1] else values


def _legs(settings: Reduction, tasks: list[Task]) -> np.ndarray:
    """Return the numbers of the legs of the trace samples, shape (tasks, events)."""
    legs = np.full((len(tasks), settings.events), np.nan)
    for row, task in enumerate(tasks) if settings.events else ():
        setting = task.problem, task.steps_per_spacing
        sampled = trace_steps(*setting, settings.recording)
        steps = programme_steps(*setting, settings.recording.origin)
        legs[row, : sampled.size] = steps.leg[np.maximum(sampled - 1, 0)]
    return legs


def _legs_at(tasks: list[Task], times: np.ndarray) -> np.ndarray:
    """Return the numbers of the legs at times in tau, shape (tasks, events); NaN where NaN.

    times : shape (tasks, 1, events).
    """
    legs = np.full(times[:, 0].shape, np.nan)
    for row, task in enumerate(tasks):
        ends = np.cumsum([leg_duration(leg) for leg in task.problem.programme])
        known = np.isfinite(times[row, 0])
        legs[row, known] = np.searchsorted(ends[:-1], times[row, 0, known] * (1.0 - 1e-12))
    return legs


def _times(settings: Reduction, tasks: list[Task]) -> np.ndarray:
    """Return the times of the curves after the velocity step, shape (tasks, samples - 1)."""
    samples, scheme = settings.numerics.curve_samples, settings.numerics.scheme
    time = np.full((len(tasks), samples - 1), np.nan)
    for row, task in enumerate(tasks) if settings.kernel_quantities.relaxation else ():
        steps_per_tau = abs(task.problem.speed * task.problem.ratio) * task.steps_per_spacing
        sampled = record_steps(task.march_steps, samples, task.problem.spectrum)
        time[row, : sampled.size] = curve_times(
            sampled, steps_per_tau, scheme, task.problem.spectrum
        )
    return time
