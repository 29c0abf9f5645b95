"""Layout of a row of the store: names, positions and shapes of the values of a record.

A row holds the curves of a record and the results of its programme, one after the other. Its
layout follows from the task and the requested results; shorter rows are padded with NaN.
"""

import math
from typing import Any

import numpy as np

from ...kernels import ENERGIES, TRACES, Quantities, SavedState, form_of, memory_size
from ...kernels.drive import DRIVE_ENERGIES, MAX_SLIP_EVENTS, PULLED_TRACES, SLIP_EVENTS, SLIPS
from ...kernels.half_space.heated_map import TEMPERATURE_TRACES
from ...kernels.half_space.tiles import TILE_SUMS
from ...kernels.scene.cycles import CYCLE_MEANS
from .recorded_steps import trace_size
from .tasks import Recording, Task

STATE_SCALARS = tuple(f"state_{name}" for name in SavedState._fields if name not in ("memory", "p"))
HALVED_STEP_SCALARS = ("mu_1", "jump", "mu_2")  # stored: number of lines, then the change of each
CONTACT_LENGTH_BINS = 40
CONTACT_LENGTH_EDGES = 2.0 ** (0.5 * np.arange(CONTACT_LENGTH_BINS + 1) - 4.0)  # in dx

Layout = dict[str, tuple[int, tuple[int, ...]]]  # name -> first column, shape


def row_layout(task: Task, quantities: Quantities, scheme: str, recording: Recording) -> Layout:
    """Return the first column and the shape of every value of a record."""
    shapes: dict[str, tuple[int, ...]] = {}
    if quantities.relaxation:
        shapes["curve"] = (recording.samples - 1,)
    if quantities.initial_rate:
        shapes["initial_rate"] = ()
    if quantities.areas and task.problem.surface.body == "half-space":
        shapes["contact_2"], shapes["contact_step"] = (), (2,)  # at v2; before and after the jump
        if quantities.relaxation:
            shapes["contact_curve"] = (recording.samples - 1,)
    effects = task.problem.effects
    if effects.heat and quantities.anything:
        shapes |= dict.fromkeys(("contact_temperature", "flash_temperature"), ())
        if effects.shear:
            shapes |= dict.fromkeys(("mu_1_shear", "mu_2_shear", "jump_shear"), ())
            if quantities.relaxation:
                shapes["curve_shear"] = (recording.samples - 1,)
    if recording.tiles and quantities.anything:
        shapes["tiles"] = len(TILE_SUMS), recording.tiles, recording.tiles
    if recording.refined_blocks:
        shapes["halved_steps"] = (1 + len(HALVED_STEP_SCALARS),)
        if quantities.relaxation:
            shapes["halved_steps_curve"] = (recording.samples - 1,)
    if recording.one_slider:
        shapes["slip_changes"] = (len(SLIPS),)
    if recording.requested:
        shapes |= _programme_shapes(task, scheme, recording)
    places: Layout = {}
    first = 0
    for name, shape in shapes.items():
        places[name] = first, shape
        first += math.prod(shape)
    return places


def row_width(places: Layout) -> int:
    """Return the number of values in a row."""
    return sum(math.prod(shape) for _, shape in places.values())


def unpack(rows: np.ndarray, places: Layout) -> dict[str, np.ndarray]:
    """Return name -> view, shape (..., *shape of the name), into rows of shape (..., width)."""
    return {
        name: rows[..., first : first + math.prod(shape)].reshape((*rows.shape[:-1], *shape))
        for name, (first, shape) in places.items()
    }


def add_to(part: np.ndarray, values: Any) -> None:
    """Add values to a part of a row, as ``unpack`` returns it; the rest of the part becomes NaN."""
    flat, added = part.reshape(-1), np.ravel(values)
    if added.size < flat.size:
        flat[added.size :] = np.nan
        flat = flat[: added.size]
    flat += added


def _snapshots(task: Task, line_shape: tuple[int, ...]) -> dict[str, tuple[int, ...]]:
    """Return the shapes of snapshots: heights and displacements of a line, pressures of a map."""
    if task.problem.surface.body == "foundation":
        return dict.fromkeys(("snapshot_height", "snapshot_displacement"), line_shape)
    snapshots, columns = line_shape
    return {"snapshot_pressure": (snapshots, task.problem.rows(task.steps_per_spacing), columns)}


def _programme_shapes(task: Task, scheme: str, recording: Recording) -> dict[str, tuple[int, ...]]:
    trace = (trace_size(task.problem, task.steps_per_spacing, recording),)
    samples = task.problem.elements * task.steps_per_spacing
    traces = PULLED_TRACES if task.problem.drive else TRACES
    if task.problem.effects.heat:
        traces += TEMPERATURE_TRACES
    units = memory_size(form_of(task.problem.spectrum, scheme))
    shapes: dict[str, dict[str, tuple[int, ...]]] = {
        "trace": dict.fromkeys(traces, trace),
        "stick_slip": dict.fromkeys(SLIPS, ()),
        "slip_events": dict.fromkeys(SLIP_EVENTS, (MAX_SLIP_EVENTS,)),
        "cycle_mean": dict.fromkeys(
            CYCLE_MEANS if task.problem.effects.shear else CYCLE_MEANS[:1], ()
        ),
        "energy": dict.fromkeys(DRIVE_ENERGIES if task.problem.drive else ENERGIES, trace),
        "contact_lengths": {"contact_length": (CONTACT_LENGTH_BINS,)},
        "snapshots": _snapshots(task, (*trace, samples)),
        "state": {
            "state_memory": (units, samples),
            "state_p": (samples,),
            **dict.fromkeys(STATE_SCALARS, ()),
        },
    }
    return {name: shape for group in recording.requested for name, shape in shapes[group].items()}
