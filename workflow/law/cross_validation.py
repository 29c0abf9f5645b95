"""Errors of a law on motions that its fit did not use."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

from .reduced_law import Law
from .residuals import residuals
from .transients import Transient, rest_durations

FOLDS = 4
MAX_FOLD_EVALUATIONS = 15  # of the residuals in the fit to all folds but one
SAME_SPEED = 0.1  # relative difference of speeds or rests that count as equal


class Search(Protocol):
    """Search for the law of one kind."""

    def fit(
        self, motions: Sequence[Transient], max_evaluations: int, start: Any = None
    ) -> tuple[Law, Any]:
        """Return the law that fits the known friction best, and a start for further fits.

        motions : those of the search, perhaps with less known friction.
        """


class HeldOut(NamedTuple):
    """Residuals on held-out motions or folds, and their description."""

    residuals: list[np.ndarray]
    description: str


def cross_validated(search: Search, motions: Sequence[Transient], start: Any) -> HeldOut:
    """Return the residuals on each fold by a fit to the other folds."""
    parts, description = _parts_to_hold_out(motions)
    held_residuals: list[np.ndarray] = []
    for fold in range(FOLDS):
        fitted, held = ([m.mu.copy() for m in motions], [np.nan * m.mu for m in motions])
        for k, rows in parts[fold::FOLDS]:
            fitted[k][rows], held[k][rows] = np.nan, motions[k].mu[rows]
        law, _ = search.fit(_with_friction(motions, fitted), MAX_FOLD_EVALUATIONS, start)
        held_residuals.append(residuals(law, _with_friction(motions, held)))
    return HeldOut(held_residuals, description)


def _with_friction(motions: Sequence[Transient], friction: list[np.ndarray]) -> list[Transient]:
    return [m._replace(mu=mu) for m, mu in zip(motions, friction, strict=True)]


def _parts_to_hold_out(motions: Sequence[Transient]) -> tuple[list[tuple[int, np.ndarray]], str]:
    """Return the parts (motion, rows) that are held out in turn, and their description.

    Parts are segments, sorted by speed so that folds have similar speeds, or quarters if there are
    few segments. A segment with a unique extreme of speed or rest stays in every fit.
    """
    parts = [(k, rows) for k, motion in enumerate(motions) for _, rows in motion.parts()]
    if len(parts) < FOLDS + 2:
        parts = [(k, part) for k, rows in parts for part in np.array_split(rows, FOLDS)]
        return parts, "each quarter of the samples in turn, by a fit to the others"
    speed = [float(np.mean(np.abs(motions[k].velocity[rows]))) for k, rows in parts]
    durations = [rest_durations(motion) for motion in motions]
    # A jump after a rest occupies two rows.
    rest = [float(durations[k][max(rows[0] - 2, 0) : rows[0]].max(initial=0)) for k, rows in parts]
    unique = {
        _unique_extreme(speed, np.argmin),
        _unique_extreme(speed, np.argmax),
        _unique_extreme(rest, np.argmax),
    }
    parts = [parts[k] for k in np.argsort(speed, kind="stable") if k not in unique]
    return parts, (
        f"each quarter of {len(parts)} segments in turn, by a fit to the others; segments with the "
        "extreme speeds or the longest rest stay in every fit"
    )


def _unique_extreme(values: Sequence[float], extreme: Callable) -> int | None:
    """Return the index of the extreme value, or None if another value is about equal."""
    k = int(extreme(values))
    others = np.delete(values, k)
    return k if (np.abs(others - values[k]) > SAME_SPEED * abs(values[k])).all() else None
