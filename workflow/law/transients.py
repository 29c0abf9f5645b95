"""Simulated motions to which laws are fitted: v(t) with its jumps, and samples of mu."""

import contextlib
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..ground import UserError
from ..reduce import RESOLVED, UNRESOLVED
from ..result import body_in_words, model_in_words
from ..study import PROGRAMME_AXES, SHIFT_KEYS

MAX_VELOCITY_CHANGE = 0.1  # relative change of the velocity within one step of a law
MAX_DISTANCE_ERROR = 0.05  # of the integrated velocity, relative to the distance
MOTION_AXES = ("velocity", *PROGRAMME_AXES, "normal_force")  # one law is fitted to all their points
TRANSIENT_VARIABLES = (
    "trace_time",
    "trace_velocity",
    "trace_distance",
    "trace_segment",
    "trace_mu",
)


class Transient(NamedTuple):
    """Motion whose velocity is linear between its rows; friction is known at some rows.

    Two rows at the same time are a jump of the velocity. Arrays have the shape (rows,).
    """

    name: str
    time: np.ndarray  # s
    velocity: np.ndarray  # m/s
    mu: np.ndarray  # NaN if unknown
    error: np.ndarray  # standard error of mu, NaN if unknown
    segment: np.ndarray  # number in the programme, from 0
    heating: np.ndarray  # temperature of the contact, degrees Celsius, NaN if unknown
    normal_force: float  # N
    temperature: float = math.nan  # degrees Celsius, NaN if unknown
    shift: str = ""  # time-temperature shift: keys of [material] as JSON
    body: str = ""  # elastic body and error of the model, in words

    @property
    def known(self) -> np.ndarray:
        """Mask of the rows with known friction."""
        return np.isfinite(self.mu)

    def parts(self) -> Iterator[tuple[str, np.ndarray]]:
        """Yield the name and the rows with known friction of every segment that has any."""
        for number in np.unique(self.segment):
            rows = np.flatnonzero((self.segment == number) & self.known)
            if rows.size:
                first, last = self.velocity[rows[0]], self.velocity[rows[-1]]
                ends = " ... ".join(dict.fromkeys(f"{v:.3g}" for v in (first, last)))
                yield f"segment {number}, {ends} m/s", rows


def transients_of(dataset: Any, point: Mapping[str, Any] | None = None) -> list[Transient]:
    """Return the motions of a result with the quantity "trace", one per programme and load.

    dataset : of ``scene.run``, or of a study. point : values on the axes of its grid, for example
    {"hurst": 0.7}; the nearest point is used, axes of one value may be omitted. Raises UserError
    for an incomplete point, a result without traces, and traces too coarse to determine v(t).
    """
    if not hasattr(dataset, "variables"):
        raise UserError(
            f"{dataset!r:.80}: must be a dataset, of ef.scene.run, ef.run or ef.open(PATH)"
        )
    missing = [name for name in TRANSIENT_VARIABLES if name not in dataset.variables]
    if missing:
        raise UserError(
            f"the result has no {missing[0]}: a law is fitted to a programme of motion; compute it "
            'with the quantity "trace"'
        )
    chosen = dataset
    for axis, value in (point or {}).items():
        try:
            chosen = chosen.sel({axis: value}, method="nearest")
        except (LookupError, TypeError, ValueError) as error:
            raise UserError(f"{axis} = {value}: the result has no such point: {error}") from error
    axes = [str(axis) for axis in chosen["trace_mu"].dims if axis != "event"]
    undetermined = [axis for axis in axes if chosen.sizes[axis] > 1 and axis not in MOTION_AXES]
    if undetermined:
        lists = ", ".join(f"{axis} of {chosen[axis].values.tolist()}" for axis in undetermined)
        raise UserError(f"the result has several points; choose one by point: {lists}")
    chosen = chosen.isel({axis: 0 for axis in axes if axis not in MOTION_AXES})
    title = str(dataset.attrs.get("title", "motion"))
    motions = []
    for place in np.ndindex(*(chosen.sizes.get(axis, 1) for axis in MOTION_AXES)):
        index = {axis: k for axis, k in zip(MOTION_AXES, place, strict=True) if axis in chosen.dims}
        varied = [axis for axis in index if chosen.sizes[axis] > 1]
        values = [f"{axis} {float(chosen[axis][index[axis]]):.3g}" for axis in varied]
        motion = chosen.isel(index)
        if int(np.max(motion.get("resolution_status", RESOLVED))) == UNRESOLVED:
            raise UserError(
                f"{title}: its contacts are not resolved (resolution_status); a law needs resolved "
                "contacts: use a smaller spacing"
            )
        motions.append(_transient(motion, ", ".join([title, *values]), _material(chosen)))
    return motions


def motions_of(results: Any, point: Mapping[str, Any] | None) -> list[Transient]:
    """Return the motions of one or several results or transients, numbered if several."""
    single = isinstance(results, Transient | str) or not isinstance(results, Sequence)
    motions: list[Transient] = []
    for result in [results] if single else results:
        motions += [result] if isinstance(result, Transient) else transients_of(result, point)
    if len(motions) > 1:
        motions = [m._replace(name=f"{k}: {m.name}") for k, m in enumerate(motions, 1)]
    return motions


def _material(dataset: Any) -> tuple[float, str]:
    """Return the temperature and the shift of a result; NaN and "" if unknown."""
    study = json.loads(dataset.attrs.get("study", "{}"))
    material, comparisons = study.get("material", {}), study.get("compare", {}).values()
    laws = {key: material[key] for key in SHIFT_KEYS if key in material}
    if not laws or any(key in comparison for comparison in comparisons for key in SHIFT_KEYS):
        return math.nan, ""  # the shift of a comparison may differ from the study
    temperature = dataset.coords.get("temperature", material["temperature"])
    return float(np.squeeze(temperature)), json.dumps(laws)


def _transient(dataset: Any, name: str, material: tuple[float, str]) -> Transient:
    """Return the motion of a dataset whose traces have only the axis "event"."""
    segment = dataset["trace_segment"].values
    recorded = np.isfinite(dataset["trace_time"].values) & (segment >= 0)

    def values(variable: str) -> np.ndarray:
        if variable not in dataset:
            return np.full(int(recorded.sum()), np.nan)
        return np.asarray(dataset[variable].values, float)[recorded]

    force = np.nan
    with contextlib.suppress(LookupError, TypeError, ValueError):
        force = float(dataset["normal_force"])
    segment = segment[recorded]
    t, v, x = values("trace_time"), values("trace_velocity"), values("trace_distance")
    _check_distance(name, t, v, x, segment)
    mu, heating = values("trace_mu"), values("trace_contact_temperature")
    rows = np.column_stack([t, v, mu, values("trace_mu_error"), segment, heating])
    for k in np.flatnonzero((np.diff(rows[:, 4]) != 0.0) & (np.diff(v) != 0.0))[::-1]:
        # Place the jump such that both velocities together lead to the second position.
        before, after, duration = v[k], v[k + 1], t[k + 1] - t[k]
        since = (x[k + 1] - x[k] - after * duration) / (before - after)
        at = t[k] + min(max(since, 0.0), duration)
        ends = [
            [at, before, np.nan, np.nan, rows[k, 4], np.nan],
            [at, after, np.nan, np.nan, rows[k + 1, 4], np.nan],
        ]
        rows = np.insert(rows, k + 1, ends, axis=0)
    time, velocity, mu, error, segments, heating = rows.T
    segments = segments.astype(int)
    body = f"{body_in_words(dataset)} {model_in_words(dataset)}".strip()
    return Transient(name, time, velocity, mu, error, segments, heating, force, *material, body)


def _check_distance(
    name: str, t: np.ndarray, v: np.ndarray, x: np.ndarray, segment: np.ndarray
) -> None:
    """Raise UserError if the integral of the sampled velocities misses the distance."""
    if t.size < 2:
        raise UserError(f"{name}: its trace holds {t.size} samples; a law needs two or more")
    inside = np.diff(segment) == 0
    error = 0.5 * (v[1:] + v[:-1]) * np.diff(t) - np.diff(x)
    missing, distance = np.abs(error[inside]).sum(), np.abs(np.diff(x)).sum()
    if missing > MAX_DISTANCE_ERROR * distance:
        raise UserError(
            f"{name}: the velocities of its trace miss {100 * missing / distance:.2g} % of the "
            "distance: its samples are too coarse; increase numerics.samples"
        )


def rest_durations(motion: Transient) -> np.ndarray:
    """Return the time (s) for which the motion has been at rest, for every row."""
    durations = np.zeros(motion.time.size)
    resting = (motion.velocity[1:] == 0.0) & (motion.velocity[:-1] == 0.0)
    for k in np.flatnonzero(resting):
        durations[k + 1] = durations[k] + motion.time[k + 1] - motion.time[k]
    return durations
