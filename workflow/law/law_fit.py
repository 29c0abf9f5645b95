"""Fit of a law to computed motions, with the error on motions that were held out."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ..given_motion import distances_between_turns, finely
from ..ground import UserError
from .cross_validation import HeldOut, Search, cross_validated
from .fitted_law import Validity
from .load_law import MIN_LOADS, LoadLaw
from .memory_law import MemoryLaw
from .memory_names import numbered, origins
from .memory_search import MemorySearch
from .reduced_law import Law
from .residuals import friction, residuals, root_mean_square, row_residuals
from .transients import MAX_VELOCITY_CHANGE, Transient, motions_of, rest_durations
from .usual_laws import LAWS_BY_KIND
from .usual_search import UsualSearch

MIN_FRICTION_SAMPLES = 20
MAX_STATES = 5
MAX_FITTED_SPEED_RATIO = 2.5  # of neighbouring speeds of a table
MIN_TABLE_SPEED = 1e-3  # relative to the fastest speed
RESTING_SPEED = 0.1  # relative to the slowest speed; contacts age below it as they do at rest
SLOW_SAMPLES = 0.02  # share of the moving samples below the slowest speed
STATELESS_RESIDUAL = 5e-3  # relative rms residual below which mu depends on the velocity alone
MIN_SCALE = 1e-300  # lower bound of a divisor
MAX_FIT_EVALUATIONS = 60  # of the residuals in a fit
MAXIMA_OVER_LOADS = (  # fields of Validity
    "rms",
    "largest",
    "usual",
    "left",
    "model_error",
    "shortest_stroke",
)


def fit_law(
    results: Any,
    *,
    states: int = 2,
    kind: str = MemoryLaw.kind,
    held_out: Any = None,
    point: Mapping[str, Any] | None = None,
) -> Law | LoadLaw:
    """Return a law fitted to the motions of one or several results of the model.

    results : datasets of ``scene.run`` or of a study with the quantity "trace", for one surface;
    three normal forces or more give a table over the load. states : number of exponential states
    besides the age of contacts, 0 to 5. kind : "states", "rate-state" or "lugre". held_out :
    results that are not fitted, for which the error is stated; by default each quarter of the
    segments in turn is predicted by a fit to the other three. In a table each inner load is also
    predicted by the laws of its neighbours. point : nearest values on the grid axes, for example
    {"hurst": 0.7}. Raises UserError for invalid arguments and results that cannot be fitted.
    """
    if kind not in LAWS_BY_KIND:
        raise UserError(f"kind = {kind!r}: must be one of {', '.join(LAWS_BY_KIND)}")
    if not (isinstance(states, int) and 0 <= states <= MAX_STATES):
        raise UserError(f"states = {states!r}: must be a whole number, 0 to {MAX_STATES}")
    motions = motions_of(results, point)
    if not motions:
        raise UserError("there is nothing to fit: no result is given")
    speeds = _table_speeds(motions)
    motions = [_refined(motion, speeds[0]) for motion in motions]
    others = [] if held_out is None else motions_of(held_out, point)
    others = [_refined(motion, speeds[0]) for motion in others]
    forces = sorted({m.normal_force for m in motions if math.isfinite(m.normal_force)})
    fit = partial(_fit_one_load, speeds=speeds, kind=kind, states=states)
    if len(forces) < 2:
        return fit(motions, others)[0]
    if kind != MemoryLaw.kind or len(forces) < MIN_LOADS:
        raise UserError(
            f"normal_force of {forces}: a law over the load requires the kind {MemoryLaw.kind} and "
            f"{MIN_LOADS} loads or more; fit one law to each load"
        )
    return _fit_loads(forces, motions, others, fit)


def _fit_one_load(
    motions: Sequence[Transient],
    others: Sequence[Transient],
    start: Any = None,
    *,
    speeds: np.ndarray,
    kind: str,
    states: int,
) -> tuple[Law, Any]:
    """Return the law of one load with its errors, and a start for the fit of the next load.

    others : held-out motions. start : parameters of the previous load, which decide whether the
    law has states; without them it has none if mu depends on the velocity alone.
    """
    _check_samples(motions)
    mu_scale = root_mean_square(friction(motions))
    stateless = MemorySearch(motions, speeds, 0)
    law_without_states, _ = stateless.fit(motions, MAX_FIT_EVALUATIONS)
    left = root_mean_square(residuals(law_without_states, motions)) / max(mu_scale, MIN_SCALE)
    search: Search = stateless
    if kind != MemoryLaw.kind:
        search = UsualSearch(motions, speeds, kind)
    elif states and (left > STATELESS_RESIDUAL if start is None else start.size):
        search = MemorySearch(motions, speeds, states)
    law, parameters = search.fit(motions, MAX_FIT_EVALUATIONS, start)
    evidence = ""
    if isinstance(search, MemorySearch) and isinstance(law, MemoryLaw):
        names, evidence = origins(motions, search.responses(law))
        law = replace(law, names=numbered(names))
    if others:
        errors = [residuals(law, [motion]) for motion in others]
        held_out = HeldOut(errors, "; ".join(motion.name for motion in others))
    else:
        held_out = cross_validated(search, motions, parameters)
    validity = replace(
        _validity(law, motions, speeds),
        usual=mu_scale,
        memories=evidence,
        left=left**2,
        held_rms=max(map(root_mean_square, held_out.residuals)),
        held_largest=float(np.max(np.abs(np.concatenate(held_out.residuals)))),
        held_out=held_out.description,
    )
    return law.with_validity(validity), parameters


def _fit_loads(
    forces: Sequence[float],
    motions: Sequence[Transient],
    others: Sequence[Transient],
    fit: Callable[..., tuple[Law, Any]],
) -> LoadLaw:
    """Return the table of the laws of several loads; each fit starts from the previous one."""
    laws: list[Any] = []
    start = None
    for force in forces:
        law, start = fit(_at_load(force, motions), _at_load(force, others), start)
        laws.append(law)
    table = LoadLaw.of(list(forces), laws)
    validities = [law.validity for law in laws]
    predicted, descriptions = _predicted_loads(table, laws, motions, others)
    errors = [*((validity.held_rms, validity.held_largest) for validity in validities), *predicted]
    rms, largest = np.max(errors, axis=0)
    segments = tuple(
        (f"{force:.4g} N, {segment}", error)
        for force, validity in zip(forces, validities, strict=True)
        for segment, error in validity.motions
    )
    validity = replace(
        validities[0],
        normal_force=math.nan,
        longest_rest=max(validity.longest_rest for validity in validities),
        held_rms=float(rms),
        held_largest=float(largest),
        held_out="; ".join([validities[0].held_out, *descriptions]),
        window=f"{validities[0].window} under each load",
        motions=segments,
        memories="; ".join(
            f"under {force:.4g} N {v.memories}"
            for force, v in zip(forces, validities, strict=True)
            if v.memories
        ),
        **{name: max(getattr(v, name) for v in validities) for name in MAXIMA_OVER_LOADS},
    )
    return table.with_validity(validity)


def _predicted_loads(
    table: LoadLaw, laws: Sequence[Any], motions: Sequence[Transient], others: Sequence[Transient]
) -> tuple[list[tuple[float, float]], list[str]]:
    """Return the errors (rms, largest) of predictions at other loads, and their descriptions.

    The laws of its two neighbours predict each inner load. The whole table predicts held-out
    motions at loads that were not fitted.
    """
    forces = table.load.tolist()
    predictions = [(table, motion) for motion in others if motion.normal_force not in forces]
    descriptions = [motion.name for _, motion in predictions]
    for k in range(1, len(forces) - 1):
        ends = [forces[k - 1], forces[k + 1]]
        neighbours = LoadLaw.of(ends, [laws[k - 1], laws[k + 1]])
        predictions += [(neighbours, motion) for motion in _at_load(forces[k], motions)]
        descriptions.append(f"{forces[k]:.4g} N by the laws of {ends[0]:.4g} and {ends[1]:.4g} N")
    errors = []
    for predictor, motion in predictions:
        law = predictor.at(normal_force=motion.normal_force)
        residual = residuals(law, [motion])
        errors.append((root_mean_square(residual), float(np.max(np.abs(residual)))))
    descriptions[-1] += f", {max(rms for rms, _ in errors):.3g} rms at most"
    return errors, descriptions


def _at_load(force: float, motions: Sequence[Transient]) -> list[Transient]:
    return [motion for motion in motions if motion.normal_force == force]


def _validity(law: Law, motions: Sequence[Transient], speeds: np.ndarray) -> Validity:
    """Return the range of the fitted motions, and the errors of the law on them."""
    errors = np.concatenate([motion.error[motion.known] for motion in motions])
    all_rows = [row_residuals(law, motion) for motion in motions]
    segments = tuple(
        (
            f"{motion.name}, {segment}" if len(motions) > 1 else segment,
            root_mean_square(residual[rows]),
        )
        for motion, residual in zip(motions, all_rows, strict=True)
        for segment, rows in motion.parts()
    )
    differences = np.concatenate([r[m.known] for r, m in zip(all_rows, motions, strict=True)])
    strokes = [distances_between_turns(motion.time, motion.velocity) for motion in motions]
    return Validity(
        slowest=float(speeds[1]),
        fastest=float(speeds[-1]),
        longest_rest=max(float(rest_durations(motion).max()) for motion in motions),
        normal_force=motions[0].normal_force,
        temperature=motions[0].temperature,
        shift=motions[0].shift,
        body=motions[0].body,
        shortest_stroke=float(np.min(np.concatenate(strokes), initial=np.inf)),
        rms=root_mean_square(differences),
        largest=float(np.max(np.abs(differences))),
        model_error=root_mean_square(errors[np.isfinite(errors)]),
        motions=segments,
        window=f"{errors.size} samples of {len(segments)} segments, all of them",
        source=motions[0].name,
    )


def _table_speeds(motions: Sequence[Transient]) -> np.ndarray:
    """Return the speeds of the tables: one for resting contacts, then a geometric series."""
    speeds = np.abs(np.concatenate([m.velocity[m.known] for m in motions]))
    moving = speeds[speeds > 0.0]
    if not moving.size:
        raise UserError("there is nothing to fit: every motion is at rest")
    fastest = float(np.max([np.max(np.abs(m.velocity)) for m in motions]))
    slowest = max(float(np.quantile(moving, SLOW_SAMPLES)), MIN_TABLE_SPEED * fastest)
    ratio = math.log(fastest / slowest) / math.log(MAX_FITTED_SPEED_RATIO)
    count = max(math.ceil(ratio - 1e-9), 1) + 1
    series = np.geomspace(slowest, fastest, count) if fastest > slowest else np.array([fastest])
    return np.concatenate([[RESTING_SPEED * slowest], series])


def _refined(motion: Transient, smallest_speed: float) -> Transient:
    """Return a motion with additional rows, of unknown friction, where its velocity changes."""
    time, velocity, samples = finely(
        motion.time, motion.velocity, smallest_speed, MAX_VELOCITY_CHANGE
    )
    known = np.full((3, time.size), np.nan)
    known[:, samples] = motion.mu, motion.error, motion.heating
    mu, error, heating = known
    following = np.minimum(np.searchsorted(samples, np.arange(time.size)), samples.size - 1)
    return motion._replace(
        time=time,
        velocity=velocity,
        mu=mu,
        error=error,
        segment=motion.segment[following],
        heating=heating,
    )


def _check_samples(motions: Sequence[Transient]) -> None:
    """Raise UserError for too few samples and for a velocity that never changes."""
    count = friction(motions).size
    if count < MIN_FRICTION_SAMPLES:
        raise UserError(
            f"there is nothing to fit: the motions hold {count} samples of friction; a law needs "
            f"{MIN_FRICTION_SAMPLES}"
        )
    if all(np.ptp(motion.velocity) == 0.0 for motion in motions):
        raise UserError("there is nothing to fit: the velocity never changes")
