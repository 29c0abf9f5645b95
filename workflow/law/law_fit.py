"""Laws fitted to computed motions, with the error on motions that were held out.

The law of states is linear in its tables D and Z_j once lengths, times and the ages are known:
those alone are searched for, by scipy's least_squares, and the tables follow by linear least
squares at every trial (variable projection: G. H. Golub and V. Pereyra, SIAM J. Numer. Anal. 10,
413 (1973)). Tables that the motions leave open stay smooth over ln v.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

import numpy as np
from scipy.linalg import lstsq
from scipy.optimize import least_squares

from ..given_motion import finely
from ..ground import UserError
from .load_law import LEAST_LOADS, LoadLaw
from .memory_law import MemoryLaw, even, odd, relaxed_to
from .reduced_law import Law, Validity, followed, mean_speed
from .transients import PIECE, Transient, motions_of
from .usual_laws import KINDS, LuGreLaw, RateStateLaw

LEAST_SAMPLES = 20
RATIO = 2.5  # of neighbouring speeds of a table, at most
DEEPEST = 1e-3  # of the fastest speed: no table begins below
BELOW = 0.1  # of the slowest speed, where contacts age as at rest and friction is linear
FEW = 0.02  # of the samples that may be slower than the first speed of a table
TINY = 1e-300  # in place of zero, to divide by
NOTHING = 5e-3  # rms over that of mu, below which mu is a function of the velocity alone
SMOOTH = 1e-2  # weight of the bends of tables, over that of the samples
LEVEL = 0.1  # weight of their values, over that of their bends
FOLDS = 4
ALIKE = 0.1  # share by which speeds of one kind differ
MOST_STATES = 5
TRIALS, AGAIN = 60, 15  # evaluations of the Jacobian, at first and for a fold
LARGEST = ("rms", "largest", "usual", "left", "model_error")  # of several loads
FAR = 12.0  # that the parameters of usual laws, most of them logarithms, go from where they begin
WIDE = 1e3  # times the whole way or time: a length or time that is none

Kept = Sequence[np.ndarray]  # of each motion, which rows count, booleans


def fit_law(
    results: Any,
    *,
    states: int = 2,
    kind: str = MemoryLaw.kind,
    held_out: Any = None,
    point: Mapping[str, Any] | None = None,
) -> Law | LoadLaw:
    """Return a law fitted to the motions of one or several results of the model.

    results : datasets of ``scene.run`` or of a study with the quantity "trace", of one surface; of
    three normal forces or more the law is a table over them. states : exponential states beside the
    memory of contacts, 0 to 5. kind : "states", "rate-state" or "lugre". held_out : results that
    are not fitted to, of which the error is stated; by default each quarter of the segments in
    turn, by a fit to the others. Of a table each load but the first and the last is held out too,
    and the law of its neighbours compared with it. point : of the grid, as {"hurst": 0.7}. Raises
    UserError where there is nothing to fit.
    """
    if kind not in KINDS:
        raise UserError(f"kind = {kind!r}: must be one of {', '.join(KINDS)}")
    if not (isinstance(states, int) and 0 <= states <= MOST_STATES):
        raise UserError(f"states = {states!r}: must be a whole number, 0 to {MOST_STATES}")
    motions = motions_of(results, point)
    if not motions:
        raise UserError("there is nothing to fit: no result is given")
    speeds = _speeds(motions)
    motions = [_fine(motion, speeds[0]) for motion in motions]
    others = [] if held_out is None else motions_of(held_out, point)
    others = [_fine(each, speeds[0]) for each in others]
    forces = sorted({each.normal_force for each in motions if math.isfinite(each.normal_force)})
    fit = partial(_fitted, speeds=speeds, kind=kind, states=states)
    if len(forces) < 2:
        return fit(motions, others)[0]
    if kind != MemoryLaw.kind or len(forces) < LEAST_LOADS:
        raise UserError(
            f"normal_force of {forces}: a law over the load is of the kind {MemoryLaw.kind} and of "
            f"{LEAST_LOADS} loads or more; fit one law to each"
        )
    return _over_loads(forces, motions, others, fit)


def _fitted(
    motions: Sequence[Transient],
    others: Sequence[Transient],
    start: Any = None,
    *,
    speeds: np.ndarray,
    kind: str,
    states: int,
) -> tuple[Law, Any]:
    """Return the law of one load with its errors, and what the fit to the next load begins with.

    others : motions that are held out. start : a law of as many states as are asked for begins
    there, where it is not None.
    """
    kept = [np.isfinite(motion.mu) for motion in motions]
    _check(motions, kept)
    usual = _rms(_kept_mu(motions, kept))
    plain = _Memory(motions, speeds, 0)
    left = _rms(_differences(plain.fit(kept, TRIALS)[0], motions, kept)) / max(usual, TINY)
    search: Any = plain
    if kind != MemoryLaw.kind:
        search = _Usual(motions, speeds, kind)
    elif states and (left > NOTHING or start is not None):
        search = _Memory(motions, speeds, states)
    law, found = search.fit(kept, TRIALS, start)
    if others:
        missed = _differences(law, others, [np.isfinite(each.mu) for each in others])
        words = "; ".join(each.name for each in others)
    else:
        missed, words = _left_out(search, motions, kept, found)
    validity = replace(
        _validity(law, motions, kept, speeds),
        usual=usual,
        left=left**2,
        held_rms=max(_rms([each]) for each in missed),
        held_largest=float(np.max(np.abs(np.concatenate(missed)))),
        held_out=words,
    )
    return law.with_validity(validity), found


def _over_loads(
    forces: Sequence[float],
    motions: Sequence[Transient],
    others: Sequence[Transient],
    fit: Callable[..., tuple[Law, Any]],
) -> LoadLaw:
    """Return the table of the laws of several loads, each searched for from that of the last."""
    laws: list[Any] = []
    start = None
    for force in forces:
        law, start = fit(_under(force, motions), _under(force, others), start)
        laws.append(law)
    table = LoadLaw.of(list(forces), laws)
    known = [law.validity for law in laws]
    missed, words = _between_loads(table, laws, motions, others)
    errors = [*((each.held_rms, each.held_largest) for each in known), *missed]
    rms, largest = np.max(errors, axis=0)
    validity = replace(
        known[0],
        normal_force=math.nan,
        longest_rest=max(each.longest_rest for each in known),
        held_rms=float(rms),
        held_largest=float(largest),
        held_out="; ".join([known[0].held_out, *words]),
        window=f"{known[0].window} under each load",
        motions=tuple(
            (f"{force:.4g} N, {name}", rms)
            for force, one in zip(forces, known, strict=True)
            for name, rms in one.motions
        ),
        **{name: max(getattr(each, name) for each in known) for name in LARGEST},
    )
    return table.with_validity(validity)


def _between_loads(
    table: LoadLaw, laws: Sequence[Any], motions: Sequence[Transient], others: Sequence[Transient]
) -> tuple[list[tuple[float, float]], list[str]]:
    """Return (rms, largest) of each motion that a table is tried on, and what that was in words.

    Each load but the ends is tried by the law of its neighbours, and so are motions of others
    under loads that no law was fitted to, by the whole table.
    """
    forces = table.load.tolist()
    tried = [(table, each) for each in others if each.normal_force not in forces]
    words = [each.name for _, each in tried]
    for k in range(1, len(forces) - 1):
        ends = [forces[k - 1], forces[k + 1]]
        neighbours = LoadLaw.of(ends, [laws[k - 1], laws[k + 1]])
        tried += [(neighbours, each) for each in _under(forces[k], motions)]
        words.append(f"{forces[k]:.4g} N by the laws of {ends[0]:.4g} and {ends[1]:.4g} N")
    errors = []
    for law, each in tried:
        under = law.at(normal_force=each.normal_force)
        (off,) = _differences(under, [each], [np.isfinite(each.mu)])
        errors.append((_rms([off]), float(np.max(np.abs(off)))))
    words[-1] += f", {max(rms for rms, _ in errors):.3g} rms at most"
    return errors, words


def _under(force: float, motions: Sequence[Transient]) -> list[Transient]:
    return [each for each in motions if each.normal_force == force]


def _validity(law: Law, motions: Sequence[Transient], kept: Kept, speeds: np.ndarray) -> Validity:
    """Return the range of motions that a law was fitted to, and its errors on them."""
    errors = np.concatenate([each.error[own] for each, own in zip(motions, kept, strict=True)])
    rows_off = [_row_differences(law, motion) for motion in motions]
    named = tuple(
        (f"{motion.name}, {name}" if len(motions) > 1 else name, _rms([each[rows]]))
        for motion, each in zip(motions, rows_off, strict=True)
        for name, rows in motion.parts()
    )
    off = [each[own] for each, own in zip(rows_off, kept, strict=True)]
    return Validity(
        slowest=float(speeds[1]),
        fastest=float(speeds[-1]),
        longest_rest=max(float(_rests(motion).max()) for motion in motions),
        normal_force=motions[0].normal_force,
        temperature=motions[0].temperature,
        shift=motions[0].shift,
        rms=_rms(off),
        largest=float(np.max(np.abs(np.concatenate(off)))),
        model_error=_rms([errors[np.isfinite(errors)]]),
        motions=named,
        window=f"{errors.size} samples of {len(named)} segments, all of them",
        source=motions[0].name,
    )


def _kept_mu(motions: Sequence[Transient], kept: Kept) -> list[np.ndarray]:
    return [motion.mu[own] for motion, own in zip(motions, kept, strict=True)]


def _speeds(motions: Sequence[Transient]) -> np.ndarray:
    """Return the speeds of the tables: in equal ratios, and one below all, where contacts age."""
    found = np.abs(np.concatenate([each.velocity[np.isfinite(each.mu)] for each in motions]))
    moving = found[found > 0.0]
    if not moving.size:
        raise UserError("there is nothing to fit: every motion is at rest")
    fastest = float(np.max([np.max(np.abs(each.velocity)) for each in motions]))
    slowest = max(float(np.quantile(moving, FEW)), DEEPEST * fastest)
    count = max(math.ceil(math.log(fastest / slowest) / math.log(RATIO) - 1e-9), 1) + 1
    found = np.geomspace(slowest, fastest, count) if fastest > slowest else np.array([fastest])
    return np.concatenate([[BELOW * slowest], found])


def _fine(motion: Transient, least: float) -> Transient:
    """Return a motion with rows between, where its velocity changes; they hold no friction."""
    time, velocity, last = finely(motion.time, motion.velocity, least, PIECE)
    mu, error = np.full(time.size, np.nan), np.full(time.size, np.nan)
    mu[last], error[last] = motion.mu, motion.error
    segment = motion.segment[np.minimum(np.searchsorted(last, np.arange(time.size)), last.size - 1)]
    return motion._replace(time=time, velocity=velocity, mu=mu, error=error, segment=segment)


def _check(motions: Sequence[Transient], kept: Kept) -> None:
    """Raise UserError where there is nothing to fit, or what does not belong together."""
    count = sum(int(each.sum()) for each in kept)
    if count < LEAST_SAMPLES:
        raise UserError(
            f"there is nothing to fit: the motions hold {count} samples of friction, a law wants "
            f"{LEAST_SAMPLES}"
        )
    if all(np.ptp(each.velocity) == 0.0 for each in motions):
        raise UserError("there is nothing to fit: the velocity never changes")


class _Memory:
    """The law of states over motions: searched in p, linear in its tables.

    p : logarithms of the lengths and of the times of contacts and states, then of the ages at all
    speeds but the fastest, where it is 1.
    """

    def __init__(self, motions: Sequence[Transient], speeds: np.ndarray, states: int) -> None:
        self.motions, self.speeds, self.states = motions, speeds, states
        eye = np.eye(speeds.size)
        self.odd = [odd(m.velocity, speeds, eye).T for m in motions]
        self.even = [even(m.velocity, speeds, eye).T for m in motions]
        self.dt = [np.diff(m.time) for m in motions]
        self.way = [_ways(m) for m in motions]
        self.memory = lru_cache(4 * (states + 1) * len(motions))(self._memory)
        self.bends = _bends(speeds)
        self.usual = _rms([m.mu[np.isfinite(m.mu)] for m in motions])

    def _memory(self, motion: int, length: float, time: float, ages: bool) -> np.ndarray:
        """Return what a state follows of each table value at every row, shape (rows, speeds)."""
        basis = (self.even if ages else self.odd)[motion]
        x = self.way[motion] * math.exp(-length) + self.dt[motion] * math.exp(-time)
        found = np.empty_like(basis)
        found[0] = basis[0]
        keep = np.exp(-x)
        # What a step adds by the change of its target alone, of all steps at once:
        added = (
            relaxed_to(basis[:-1], basis[:-1], basis[1:], x[:, None]) - keep[:, None] * basis[:-1]
        )
        for k in range(x.size):
            found[k + 1] = found[k] * keep[k] + added[k]
        return found

    def _design(self, p: np.ndarray, motion: int) -> np.ndarray:
        """Return the derivatives of mu by D and Z_j at every row, shape (rows, tables)."""
        states, count = self.states, self.speeds.size
        lengths, times = p[: states + 1], p[states + 1 : 2 * states + 2]
        parts = [self.odd[motion]]
        parts += [self.memory(motion, lengths[j], times[j], False) for j in range(1, states + 1)]
        whole = np.concatenate(parts, 1)
        if not states:
            return whole
        ages = np.concatenate([np.exp(p[2 * states + 2 :]), [1.0]])
        assert ages.size == count
        return whole * (self.memory(motion, lengths[0], times[0], True) @ ages)[:, None]

    def _solved(self, p: np.ndarray, kept: Kept) -> tuple[np.ndarray, np.ndarray]:
        """Return the tables for p, and the residuals with those of smoothness."""
        rows = [self._design(p, k)[own] for k, own in enumerate(kept)]
        mu = np.concatenate(_kept_mu(self.motions, kept))
        matrix = np.concatenate(rows)
        weight = SMOOTH * math.sqrt(mu.size)
        smooth = weight * np.kron(np.eye(self.states + 1), self.bends)
        whole = np.concatenate([matrix, smooth])
        right = np.concatenate([mu, np.zeros(len(smooth))])
        tables = lstsq(whole, right, lapack_driver="gelsy", check_finite=False)[0]
        bent = whole @ tables - right
        if not self.states:
            return tables, bent
        ages = np.concatenate([p[2 * self.states + 2 :], [0.0]])
        return tables, np.concatenate([bent, weight * self.usual * (self.bends @ ages)])

    def fit(self, kept: Kept, trials: int, start: Any = None) -> tuple[MemoryLaw, Any]:
        """Return the law that fits the rows ``kept`` best, and its p.

        start : a p to go on from, whose order of the states is kept; else their lengths rise.
        """
        p, states, count = np.zeros(0), self.states, self.speeds.size
        if states:
            first, low, high = self._begin()
            best = least_squares(
                lambda p: self._solved(p, kept)[1],
                np.clip(first if start is None else start, low, high),
                bounds=(low, high),
                x_scale="jac",
                max_nfev=trials,
            )
            p = best.x
            if start is None:
                order = np.append(0, 1 + np.argsort(p[1 : states + 1]))
                p = np.concatenate([p[order], p[states + 1 + order], p[2 * states + 2 :]])
        tables = self._solved(p, kept)[0].reshape(states + 1, count)
        lengths, times = p[: states + 1], p[states + 1 : 2 * states + 2]
        ages = np.concatenate([np.exp(p[2 * states + 2 :]), [1.0]]) if states else np.ones(count)
        law = MemoryLaw(
            speed=self.speeds,
            direct=tables[0],
            target=tables[1:],
            rate_per_length=np.exp(-lengths) if states else np.zeros(1),
            rate=np.exp(-times) if states else np.zeros(1),
            age=ages,
        )
        return law, p

    def _begin(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return where the search begins, and the least and largest p."""
        states, ages = self.states, self.speeds.size - 1
        ways, times = np.concatenate(self.way), np.concatenate(self.dt)
        whole_way, whole_time, parts = _extent(self.motions)
        way, time = whole_way / parts, whole_time / parts
        shares = np.geomspace(0.01, 0.2, states + 2)[1:-1]
        lengths = np.concatenate([[0.07], shares]) * way
        lasting = np.concatenate([[0.3], shares]) * time
        first = [np.log(lengths), np.log(lasting), np.linspace(0.5, 0.0, ages + 1)[:-1]]
        least = math.log(0.1 * ways[ways > 0.0].min()), math.log(0.1 * times[times > 0.0].min())
        most = math.log(WIDE * whole_way), math.log(WIDE * whole_time)
        low = [np.full(states + 1, least[0]), np.full(states + 1, least[1]), np.full(ages, -5.0)]
        high = [np.full(states + 1, most[0]), np.full(states + 1, most[1]), np.full(ages, 5.0)]
        return np.concatenate(first), np.concatenate(low), np.concatenate(high)


class _Usual:
    """Rate-and-state friction, with either state, or LuGre over motions."""

    def __init__(self, motions: Sequence[Transient], speeds: np.ndarray, kind: str) -> None:
        self.motions = motions
        self.validity = Validity(slowest=float(speeds[1]), fastest=float(speeds[-1]))
        self.level = max(_rms([m.mu[np.isfinite(m.mu)] for m in motions]), TINY)
        self.middle = float(np.sqrt(speeds[1] * speeds[-1]))
        way, _, parts = _extent(motions)
        length = math.log(0.05 * way / parts)
        if kind == RateStateLaw.kind:
            self.makes: list[Callable] = [
                partial(self._aged, ageing=ageing) for ageing in (False, True)
            ]
            self.first = np.array([-2.0, 0.05, length, 1.0])
        else:
            self.makes = [self._lugre]
            self.first = np.array([math.log(self.level) - length, 0.0, 0.0, 0.0, 0.0, 0.0])

    def _aged(self, p: np.ndarray, ageing: bool) -> Law:
        a, b, mu = self.level * math.exp(p[0]), self.level * p[1], self.level * p[3]
        return RateStateLaw(a, b, math.exp(p[2]), mu, self.middle, ageing, validity=self.validity)

    def _lugre(self, p: np.ndarray) -> Law:
        coulomb, static = map(float, self.level * np.exp(p[3:5]))
        damping, viscous = map(float, p[1:3] * self.level / self.middle)
        stribeck = self.middle * math.exp(p[5])
        return LuGreLaw(
            math.exp(p[0]), damping, viscous, coulomb, static, stribeck, validity=self.validity
        )

    def fit(self, kept: Kept, trials: int, start: Any = None) -> tuple[Law, Any]:
        """Return the law that fits the rows ``kept`` best, and what a fit can go on from."""
        found = []
        for make, first in [start] if start else [(make, self.first) for make in self.makes]:

            def off(p: np.ndarray, make: Callable = make) -> np.ndarray:
                return np.concatenate(_differences(make(p), self.motions, kept)) / self.level

            bounds = self.first - FAR, self.first + FAR
            best = least_squares(off, first, bounds=bounds, x_scale="jac", max_nfev=trials)
            found.append((best.cost, make, best.x))
        _, make, p = min(found, key=lambda each: each[0])
        return make(p), (make, p)


def _left_out(
    search: Any, motions: Sequence[Transient], kept: Kept, start: Any
) -> tuple[list[np.ndarray], str]:
    """Return the errors on each quarter of the segments by a fit to the others, and words."""
    parts = [(k, rows) for k, motion in enumerate(motions) for _, rows in motion.parts()]
    if len(parts) < FOLDS + 2:
        parts = [(k, own) for k, rows in parts for own in np.array_split(rows, FOLDS)]
        words = "each quarter of the samples in turn, by a fit to the others"
    else:  # segments of one speed part, and none leaves that alone reaches an end of the range
        speed = [float(np.mean(np.abs(motions[k].velocity[rows]))) for k, rows in parts]
        rests = [_rests(motion) for motion in motions]  # a jump after one stands in two rows
        rest = [float(rests[k][max(rows[0] - 2, 0) : rows[0]].max(initial=0)) for k, rows in parts]
        alone = {_alone(speed, np.argmin), _alone(speed, np.argmax), _alone(rest, np.argmax)}
        parts = [parts[k] for k in np.argsort(speed, kind="stable") if k not in alone]
        words = f"each quarter of {len(parts)} segments in turn, by a fit to the others; the "
        words += "others alone reach the slowest or fastest speed, or follow the longest rest"
    missed: list[np.ndarray] = []
    for fold in range(FOLDS):
        others = [own.copy() for own in kept]
        for k, rows in parts[fold::FOLDS]:
            others[k][rows] = False
        law, _ = search.fit(others, AGAIN, start)
        gone = [own & ~other for own, other in zip(kept, others, strict=True)]
        missed.append(np.concatenate(_differences(law, motions, gone)))
    return missed, words


def _row_differences(law: Law, motion: Transient) -> np.ndarray:
    """Return mu of the law less that of the model at every row of a motion."""
    return followed(law, motion.time, motion.velocity) - motion.mu


def _differences(law: Law, motions: Sequence[Transient], kept: Kept) -> list[np.ndarray]:
    return [_row_differences(law, m)[own] for m, own in zip(motions, kept, strict=True)]


def _ways(motion: Transient) -> np.ndarray:
    """Return how far a motion goes between rows, m."""
    return np.diff(motion.time) * list(map(mean_speed, motion.velocity[:-1], motion.velocity[1:]))


def _extent(motions: Sequence[Transient]) -> tuple[float, float, int]:
    """Return how far (m) and how long (s) all motions go, and how many segments they have."""
    way = sum(float(_ways(m).sum()) for m in motions)
    time = sum(float(m.time[-1] - m.time[0]) for m in motions)
    return way, time, sum(len(list(m.parts())) for m in motions)


def _bends(speeds: np.ndarray) -> np.ndarray:
    """Return rows that are zero on tables without bends over ln v, and small on small ones."""
    count = speeds.size
    level = LEVEL * np.eye(count)
    if count < 3:
        return level
    slope = np.diff(np.eye(count), axis=0) / np.diff(np.log(speeds))[:, None]
    return np.concatenate([np.diff(slope, axis=0), level])


def _rests(motion: Transient) -> np.ndarray:
    """Return for how long a motion has been at rest at every row, s."""
    rests = np.zeros(motion.time.size)
    still = (motion.velocity[1:] == 0.0) & (motion.velocity[:-1] == 0.0)
    for k in np.flatnonzero(still):
        rests[k + 1] = rests[k] + motion.time[k + 1] - motion.time[k]
    return rests


def _alone(values: Sequence[float], end: Callable) -> int | None:
    """Return which of the values is the largest or smallest and has none like it."""
    k = int(end(values))
    others = np.delete(values, k)
    return k if (np.abs(others - values[k]) > ALIKE * abs(values[k])).all() else None


def _rms(parts: Sequence[np.ndarray]) -> float:
    """Return the root of the mean square of all numbers, NaN of none."""
    found = np.concatenate(parts)
    return float(np.sqrt(np.mean(found**2))) if found.size else math.nan
