"""Motions of the model as laws are fitted to them: v(t) with its jumps, and mu where it is kept."""

import contextlib
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..ground import UserError
from ..reduce import RESOLVED, UNRESOLVED
from ..study import PROGRAMME_AXES, SHIFT_KEYS

PIECE = 0.1  # change of the velocity, as a share of it, that a step takes at most
COARSE = 0.05  # of a whole way, that sampled velocities may miss
MOVED = ("velocity", *PROGRAMME_AXES, "normal_force")  # axes along which motions of one law differ
NEEDED = ("trace_time", "trace_velocity", "trace_distance", "trace_segment", "trace_mu")


class Transient(NamedTuple):
    """One motion: velocities linear between times, of which some are kept samples of friction.

    Two rows of one time are a jump of the velocity. All of shape (rows,).
    """

    name: str
    time: np.ndarray  # s
    velocity: np.ndarray  # m/s
    mu: np.ndarray  # NaN where none is known
    error: np.ndarray  # standard error of mu, NaN where none is known
    segment: np.ndarray  # of the programme, from 0
    normal_force: float  # N
    temperature: float = math.nan  # degrees Celsius, NaN where it is not known
    shift: str = ""  # of the times of the material, a table of [material] as JSON

    def parts(self) -> Iterator[tuple[str, np.ndarray]]:
        """Yield name and rows of every segment in which friction is known."""
        for number in np.unique(self.segment):
            rows = np.flatnonzero((self.segment == number) & np.isfinite(self.mu))
            if rows.size:
                first, last = self.velocity[rows[0]], self.velocity[rows[-1]]
                ends = " ... ".join(dict.fromkeys(f"{v:.3g}" for v in (first, last)))
                yield f"segment {number}, {ends} m/s", rows


def transients_of(dataset: Any, point: Mapping[str, Any] | None = None) -> list[Transient]:
    """Return the motions of a result with the quantity "trace", one of every motion and load.

    dataset : of ``scene.run``, or of a study. point : the place on the axes of its grid, nearest
    values, as {"hurst": 0.7}; an axis of one value may be left out. Raises UserError for a point
    that is not given whole, without traces, and for traces too coarse to know v(t) from.
    """
    missing = [name for name in NEEDED if name not in getattr(dataset, "variables", ())]
    if missing:
        said = 'a law is fitted to a programme of motion; ask for the quantity "trace"'
        raise UserError(f"the result has no {missing[0]}: {said}")
    chosen = dataset
    for axis, value in (point or {}).items():
        try:
            chosen = chosen.sel({axis: value}, method="nearest")
        except (LookupError, TypeError, ValueError) as error:
            raise UserError(f"{axis} = {value}: the result has no such point: {error}") from error
    axes = [str(axis) for axis in chosen["trace_mu"].dims if axis != "event"]
    several = [axis for axis in axes if chosen.sizes[axis] > 1 and axis not in MOVED]
    if several:
        lists = ", ".join(f"{axis} of {chosen[axis].values.tolist()}" for axis in several)
        raise UserError(f"the result has several points; say which: {lists}")
    chosen = chosen.isel({axis: 0 for axis in axes if axis not in MOVED})
    found = []
    for at in np.ndindex(*(chosen.sizes.get(axis, 1) for axis in MOVED)):
        own = {axis: k for axis, k in zip(MOVED, at, strict=True) if axis in chosen.dims}
        parted = [axis for axis in own if chosen.sizes[axis] > 1]
        words = [f"{axis} {float(chosen[axis][own[axis]]):.3g}" for axis in parted]
        title = str(dataset.attrs.get("title", "motion"))
        if int(np.max(chosen.isel(own).get("resolution_status", RESOLVED))) == UNRESOLVED:
            raise UserError(
                f"{title}: its contacts are no wider than a sample (resolution_status); a law is "
                "fitted to resolved ones: take smaller spacings"
            )
        found.append(_transient(chosen.isel(own), ", ".join([title, *words]), _material(chosen)))
    return found


def motions_of(results: Any, point: Mapping[str, Any] | None = None) -> list[Transient]:
    """Return the motions of one or several results, or of transients. Raises UserError."""
    one = isinstance(results, Transient) or not isinstance(results, Sequence)
    found: list[Transient] = []
    for each in [results] if one else results:
        found += [each] if isinstance(each, Transient) else transients_of(each, point)
    if len(found) > 1:
        found = [own._replace(name=f"{k}: {own.name}") for k, own in enumerate(found, 1)]
    return found


def _material(dataset: Any) -> tuple[float, str]:
    """Return the temperature of the material of a result (NaN) and how its times shift ("")."""
    study = json.loads(dataset.attrs.get("study", "{}"))
    material, others = study.get("material", {}), study.get("compare", {}).values()
    laws = {key: material[key] for key in SHIFT_KEYS if key in material}
    if not laws or any(key in other for other in others for key in SHIFT_KEYS):
        return math.nan, ""  # or which of several it is cannot be told
    temperature = dataset.coords.get("temperature", material["temperature"])
    return float(np.squeeze(temperature)), json.dumps(laws)


def _transient(chosen: Any, name: str, material: tuple[float, str]) -> Transient:
    """Return the motion of a dataset whose traces have the axis "event" alone."""
    segment = chosen["trace_segment"].values
    known = np.isfinite(chosen["trace_time"].values) & (segment >= 0)

    def values(variable: str) -> np.ndarray:
        if variable not in chosen:
            return np.full(int(known.sum()), np.nan)
        return np.asarray(chosen[variable].values, float)[known]

    force = np.nan
    with contextlib.suppress(LookupError, TypeError, ValueError):
        force = float(chosen["normal_force"])
    t, v, x = values("trace_time"), values("trace_velocity"), values("trace_distance")
    _check_way(name, t, v, x, segment[known])
    rows = np.column_stack([t, v, values("trace_mu"), values("trace_mu_error"), segment[known]])
    for k in np.flatnonzero((np.diff(rows[:, 4]) != 0.0) & (np.diff(v) != 0.0))[::-1]:
        # A jump between two kept samples is where both velocities lead to the second place.
        before, after, duration = v[k], v[k + 1], t[k + 1] - t[k]
        since = (x[k + 1] - x[k] - after * duration) / (before - after)
        at = t[k] + min(max(since, 0.0), duration)
        ends = [
            [at, before, np.nan, np.nan, rows[k, 4]],
            [at, after, np.nan, np.nan, rows[k + 1, 4]],
        ]
        rows = np.insert(rows, k + 1, ends, axis=0)
    time, velocity, mu, error, parts = rows.T
    return Transient(name, time, velocity, mu, error, parts.astype(int), force, *material)


def _check_way(name: str, t: np.ndarray, v: np.ndarray, x: np.ndarray, segment: np.ndarray) -> None:
    """Raise UserError where velocities at the kept samples do not lead along the way."""
    if t.size < 2:
        raise UserError(f"{name}: holds {t.size} samples of its trace, too few for a law")
    inside = np.diff(segment) == 0
    off = 0.5 * (v[1:] + v[:-1]) * np.diff(t) - np.diff(x)
    missed, way = np.abs(off[inside]).sum(), np.abs(np.diff(x)).sum()
    if missed > COARSE * way:
        raise UserError(
            f"{name}: the velocities of its trace miss {100 * missed / way:.2g} % of the way: its "
            "samples are too coarse to know v(t) from; ask for more numerics.samples"
        )
