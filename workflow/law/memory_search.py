"""Search for the law with exponential states that fits motions best.

For given lengths, times and ages the law is linear in its tables D and Z_j. scipy's
``least_squares`` therefore searches for lengths, times and ages only, and every evaluation solves a
linear least-squares problem for the tables (variable projection: G. H. Golub and V. Pereyra, SIAM
J. Numer. Anal. 10, 413 (1973)). Where motions do not determine the tables, these are smooth.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.linalg import lstsq
from scipy.optimize import least_squares

from .memory_law import MemoryLaw, even, odd, relaxed_to
from .residuals import distances, extent_of, friction, root_mean_square
from .transients import Transient

CURVATURE_WEIGHT = 1e-2  # of the curvature of tables, relative to the samples
VALUE_WEIGHT = 0.1  # of the values of tables, relative to their curvature
INFINITE_EXTENT = 1e3  # upper bound of lengths and times, relative to all motions together
AGE_LENGTH, AGE_TIME = 0.07, 0.3  # initial guess, relative to the mean of a segment
STATE_SHARES = (0.01, 0.2)  # initial lengths and times, relative to the mean of a segment
MAX_LOG_AGE = 5.0


class _Parameters(NamedTuple):
    """Logarithms of the nonlinear parameters; those of the age of contacts come first."""

    lengths: np.ndarray  # shape (states + 1,)
    times: np.ndarray  # shape (states + 1,)
    ages: np.ndarray  # at all speeds but the fastest, where the age is 1


class MemorySearch:
    """Least-squares search for a MemoryLaw over motions.

    motions : with rows dense enough for one step from row to row. speeds : of the tables, m/s.
    """

    def __init__(self, motions: Sequence[Transient], speeds: np.ndarray, states: int) -> None:
        self.motions, self.speeds, self.states = motions, speeds, states
        eye = np.eye(speeds.size)
        self.odd = [odd(m.velocity, speeds, eye).T for m in motions]
        self.even = [even(m.velocity, speeds, eye).T for m in motions]
        self.dt = [np.diff(m.time) for m in motions]
        self.distances = [distances(m) for m in motions]
        self.memory = lru_cache(4 * (states + 1) * len(motions))(self._memory)
        self.roughness = _roughness(speeds)
        self.mu_scale = root_mean_square(friction(motions))

    def fit(
        self, motions: Sequence[Transient], max_evaluations: int, start: np.ndarray | None = None
    ) -> tuple[MemoryLaw, np.ndarray]:
        """Return the law that fits the known friction best, and its parameters.

        motions : those of the search, perhaps with less known friction.
        start : parameters of a previous fit, whose order of states is kept; otherwise states are
        sorted by length. max_evaluations : of the residuals, without those for derivatives.
        """
        p, states = np.zeros(0), self.states
        if states:
            guess, low, high = self._guess_and_bounds()
            best = least_squares(
                lambda p: self._solved(p, motions)[1],
                np.clip(guess if start is None else start, low, high),
                bounds=(low, high),
                x_scale="jac",
                max_nfev=max_evaluations,
            )
            p = best.x
            if start is None:
                lengths, times, ages = self._split(p)
                order = np.append(0, 1 + np.argsort(lengths[1:]))
                p = np.concatenate([lengths[order], times[order], ages])
        tables = self._solved(p, motions)[0].reshape(states + 1, self.speeds.size)
        parameters = self._split(p)
        law = MemoryLaw(
            speed=self.speeds,
            direct=tables[0],
            target=tables[1:],
            rate_per_length=np.exp(-parameters.lengths) if states else np.zeros(1),
            rate=np.exp(-parameters.times) if states else np.zeros(1),
            age=self._ages(parameters) if states else np.ones(self.speeds.size),
        )
        return law, p

    def responses(self, law: MemoryLaw) -> list[list[np.ndarray]]:
        """Return even responses over the motions: at once, then by each memory of a law.

        That of a memory has one column per speed, and one per motion for the initial value.
        """
        responses = [self.even]
        for per_length, per_time in zip(law.rate_per_length, law.rate, strict=True):
            rows = []
            for k in range(len(self.motions)):
                decay = np.exp(-np.cumsum(self.distances[k] * per_length + self.dt[k] * per_time))
                start = np.zeros((decay.size + 1, len(self.motions)))
                start[:, k] = np.append(1.0, decay)
                with np.errstate(divide="ignore"):
                    memory = self._memory(k, -np.log(per_length), -np.log(per_time), True)
                rows.append(np.concatenate([self.even[k], memory, start], 1))
            responses.append(rows)
        return responses

    def _split(self, p: np.ndarray) -> _Parameters:
        count = self.states + 1
        return _Parameters(p[:count], p[count : 2 * count], p[2 * count :])

    def _ages(self, parameters: _Parameters) -> np.ndarray:
        """Return the steady age of contacts at every speed."""
        return np.concatenate([np.exp(parameters.ages), [1.0]])

    def _memory(self, motion: int, length: float, time: float, of_age: bool) -> np.ndarray:
        """Return the derivatives of a state with respect to its table, shape (rows, speeds).

        length, time : logarithms. of_age : whether it is the age of contacts, whose table is even.
        """
        target = (self.even if of_age else self.odd)[motion]
        x = self.distances[motion] * math.exp(-length) + self.dt[motion] * math.exp(-time)
        state = np.empty_like(target)
        state[0] = target[0]
        decay = np.exp(-x)
        # Contribution of the targets to each step, for all steps at once:
        added = (
            relaxed_to(target[:-1], target[:-1], target[1:], x[:, None])
            - decay[:, None] * target[:-1]
        )
        for k in range(x.size):
            state[k + 1] = state[k] * decay[k] + added[k]
        return state

    def _design(self, p: np.ndarray, motion: int) -> np.ndarray:
        """Return the derivatives of mu with respect to D and Z_j, shape (rows, table values)."""
        if not self.states:
            return np.concatenate([self.odd[motion]], 1)
        parameters = self._split(p)
        pairs = list(zip(parameters.lengths, parameters.times, strict=True))
        parts = [self.odd[motion]]
        parts += [self.memory(motion, length, time, False) for length, time in pairs[1:]]
        age = self.memory(motion, *pairs[0], True) @ self._ages(parameters)
        return np.concatenate(parts, 1) * age[:, None]

    def _solved(self, p: np.ndarray, motions: Sequence[Transient]) -> tuple[np.ndarray, np.ndarray]:
        """Return the best tables for p, and the residuals of friction and of smoothness."""
        matrix = np.concatenate([self._design(p, k)[m.known] for k, m in enumerate(motions)])
        mu = friction(motions)
        weight = CURVATURE_WEIGHT * math.sqrt(mu.size)
        smoothness = weight * np.kron(np.eye(self.states + 1), self.roughness)
        system = np.concatenate([matrix, smoothness])
        right = np.concatenate([mu, np.zeros(len(smoothness))])
        tables = lstsq(system, right, lapack_driver="gelsy", check_finite=False)[0]
        residual = system @ tables - right
        if not self.states:
            return tables, residual
        ages = np.concatenate([self._split(p).ages, [0.0]])
        roughness = weight * self.mu_scale * (self.roughness @ ages)
        return tables, np.concatenate([residual, roughness])

    def _guess_and_bounds(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the initial guess of p, and its lower and upper bounds."""
        states, ages = self.states, self.speeds.size - 1
        steps, times = np.concatenate(self.distances), np.concatenate(self.dt)
        extent = extent_of(self.motions)
        distance, time = extent.distance / extent.segments, extent.time / extent.segments
        shares = np.geomspace(*STATE_SHARES, states + 2)[1:-1]
        guess = _Parameters(
            np.log(np.concatenate([[AGE_LENGTH], shares]) * distance),
            np.log(np.concatenate([[AGE_TIME], shares]) * time),
            np.linspace(0.5, 0.0, ages + 1)[:-1],
        )
        counts = states + 1, states + 1, ages
        shortest = 0.1 * steps[steps > 0.0].min(), 0.1 * times[times > 0.0].min()
        longest = INFINITE_EXTENT * extent.distance, INFINITE_EXTENT * extent.time
        low = np.repeat([*map(math.log, shortest), -MAX_LOG_AGE], counts)
        high = np.repeat([*map(math.log, longest), MAX_LOG_AGE], counts)
        return np.concatenate(guess), low, high


def _roughness(speeds: np.ndarray) -> np.ndarray:
    """Return the matrix that maps a table to its curvatures over ln v and weighted values."""
    count = speeds.size
    values = VALUE_WEIGHT * np.eye(count)
    if count < 3:
        return values
    slope = np.diff(np.eye(count), axis=0) / np.diff(np.log(speeds))[:, None]
    return np.concatenate([np.diff(slope, axis=0), values])
