"""How a row of the store is laid out: which values of a record stand where, and their times.

A row holds, one after the other, what is a curve or belongs to a programme. Its layout follows
from the task and from what is asked for; rows of a shard are filled up with NaN.
"""

import math

import numpy as np

from ...kernels import ENERGIES, TRACES, Quantities, SavedState, form_of, memory_size
from ...kernels.drive import MAX_SLIP_EVENTS, PULLED_TRACES, SLIP_EVENTS, SLIPS
from .recorded_steps import trace_steps
from .tasks import Recording, Task

STATE = tuple(f"state_{name}" for name in SavedState._fields if name not in ("memory", "p"))
BINS = 40
EDGES = 2.0 ** (0.5 * np.arange(BINS + 1) - 4.0)  # of contact lengths, in dx

Layout = dict[str, tuple[int, tuple[int, ...]]]  # name -> first column, shape


def row_layout(task: Task, quantities: Quantities, scheme: str, recording: Recording) -> Layout:
    """Return where the values of a record stand in its row, and their shapes."""
    shapes: dict[str, tuple[int, ...]] = {}
    if quantities.relaxation:
        shapes["curve"] = (recording.samples - 1,)
    if quantities.initial_rate:
        shapes["initial_rate"] = ()
    if recording.refined_blocks:
        shapes["halved_steps"] = (
            4,
        )  # the number of lines, and the changes of HALVED_STEP_SCALARS in halved_steps.py
        if quantities.relaxation:
            shapes["halved_steps_curve"] = (recording.samples - 1,)
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
    """Return name -> values of rows, shape (..., width), each of shape (..., *its own)."""
    return {
        name: rows[..., first : first + math.prod(shape)].reshape(*rows.shape[:-1], *shape)
        for name, (first, shape) in places.items()
    }


def _snapshots(task: Task, of_line: tuple[int, ...]) -> dict[str, tuple[int, ...]]:
    """Return the shapes of snapshots: of a line what they show, of a map its pressures."""
    if task.problem.surface.body == "foundation":
        return dict.fromkeys(("snapshot_height", "snapshot_displacement"), of_line)
    kept, columns = of_line
    return {"snapshot_pressure": (kept, task.problem.rows(task.steps_per_spacing), columns)}


def _programme_shapes(task: Task, scheme: str, recording: Recording) -> dict[str, tuple[int, ...]]:
    kept = (trace_steps(task.problem, task.steps_per_spacing, recording).size,)
    samples = task.problem.elements * task.steps_per_spacing
    units = memory_size(form_of(task.problem.spectrum, scheme))
    shapes: dict[str, dict[str, tuple[int, ...]]] = {
        "trace": dict.fromkeys(PULLED_TRACES if task.problem.drive else TRACES, kept),
        "stick_slip": dict.fromkeys(SLIPS, ()),
        "slip_events": dict.fromkeys(SLIP_EVENTS, (MAX_SLIP_EVENTS,)),
        "cycle_mean": {"mu_cycle_mean": ()},
        "energy": dict.fromkeys(ENERGIES, kept),
        "contact_lengths": {"contact_length": (BINS,)},
        "snapshots": _snapshots(task, (*kept, samples)),
        "state": {
            "state_memory": (units, samples),
            "state_p": (samples,),
            **dict.fromkeys(STATE, ()),
        },
    }
    return {name: shape for asked in recording.requested for name, shape in shapes[asked].items()}
