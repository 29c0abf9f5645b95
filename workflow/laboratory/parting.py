"""Division of a record into stretches of constant velocity, and the velocity steps between them.

Velocities may be noisy, zero or negative. Stretches are separated on the scale asinh(v/s), which
is logarithmic far above the noise level s of the velocity and linear below it.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..ground import UserError, counted
from .estimate import MAX_CHANCE_ERRORS, noise_of
from .record import Record

MIN_LOG_VELOCITY_CHANGE = 0.02  # smallest detected change of log velocity
MIN_STRETCH_SAMPLES = 12  # smallest number of samples of a stretch
MIN_MEAN_ERRORS = 5.0  # standard errors by which the means of two stretches must differ
MAX_VELOCITY_ERROR = 0.05  # largest relative standard error of a velocity
MIN_SIGN_SHARE = 0.2  # of the samples of a stretch, with friction of the other sign
LINEAR_NOISE_RATIO = 3.0  # s over the noise; the scale of velocities is linear below s
MIN_LINEAR_SHARE = 1e-9  # smallest s over the largest speed, for velocities without noise


class MeasuredStep(NamedTuple):
    """One measured velocity step."""

    name: str  # name of the file, and number of the step in it if there are several
    v1: float  # m/s
    v2: float
    change: float  # s: between the last sample at v1 and the first at v2
    before: np.ndarray  # friction in the later half of sliding at v1, shape (samples,)
    before_time: np.ndarray  # times of these samples since the middle of the change, s; negative
    time: np.ndarray  # s since the middle of the change, at v2, shape (n,)
    after: np.ndarray  # friction at these times

    @property
    def ratio(self) -> float:
        """Return v2/v1."""
        return self.v2 / self.v1


def measured_steps(record: Record, window: float | None = None) -> list[MeasuredStep]:
    """Return the velocity steps of a record, in order.

    window : time used after each step, s; by default the whole stretch. A change to or from rest
    is not a step, nor is a change of direction. Raises UserError for a record without a step, for
    too few samples after a step, and for velocities that are lost in noise.
    """
    stretches = _sliding(record)
    pairs = [(one, two) for one, two in pairwise(stretches) if one.sign * two.sign > 0.0]
    if not pairs or (np.all(np.diff(record.velocity) > 0.0) and not record.is_named):
        raise UserError(_no_step(record, stretches))
    for stretch in stretches:
        positive = float(np.mean(record.friction[stretch.where] > 0.0)) if stretch.sign else 1.0
        if MIN_SIGN_SHARE < positive < 1.0 - MIN_SIGN_SHARE:
            raise UserError(
                f"fit {record.name}: friction changes sign at one velocity, as in reciprocating "
                "motion: holds no steady sliding; scene.run takes such a motion as its programme"
            )
    names = [f"{record.name}, step {number}" for number in range(1, len(pairs) + 1)]
    names = names if len(pairs) > 1 else [record.name]
    return [
        _step_between(record, name, *pair, window) for name, pair in zip(names, pairs, strict=True)
    ]


def no_steps_of(record: Record) -> list[str]:
    """Describe the velocity changes that are not steps, and the backward slides."""
    stretches = _sliding(record)
    rests = sum(stretch.sign == 0.0 for stretch in stretches)
    reversals = sum(one.sign * two.sign < 0.0 for one, two in pairwise(stretches))
    backwards = sum(stretch.sign < 0.0 for stretch in stretches)
    named = ((rests, "rest"), (reversals, "reversal"))
    counts = [counted(count, noun) for count, noun in named if count]
    lines = [f"left out: {' and '.join(counts)}, which are no velocity steps"] if counts else []
    if any(s.sign > 0.0 and record.friction[s.where].mean() < 0.0 for s in stretches):
        lines.append("friction is negative where the velocity is positive: its sign is turned")
    if backwards:
        verb = "is" if backwards == 1 else "are"
        lines.append(f"{counted(backwards, 'backward slide')} {verb} fitted as sliding forward")
    return lines


class _Stretch(NamedTuple):
    """A stretch of constant velocity."""

    where: slice
    sign: float  # of the velocity; 0 at rest


def _sliding(record: Record) -> list[_Stretch]:
    """Return the stretches of constant velocity. Raises UserError for velocities lost in noise."""
    v, sliding = record.velocity, []
    stretches = constant_stretches(_on_scale(v))
    fastest = max((abs(float(v[where].mean())) for where in stretches), default=0.0)
    for where in stretches:
        mean, scatter = float(v[where].mean()), float(v[where].std(ddof=1))
        error = scatter / np.sqrt(v[where].size)
        known = mean != 0.0 and error <= MAX_VELOCITY_ERROR * abs(mean)
        still = abs(mean) <= MAX_CHANCE_ERRORS * error and error <= MAX_VELOCITY_ERROR * fastest
        if not known and not still:
            raise UserError(
                f"fit {record.name}: the velocity scatters by {scatter:.2g} m/s about {mean:.3g} "
                "m/s, too much noise to know it: smooth it, or give the commanded velocity"
            )
        sliding.append(_Stretch(where, float(np.sign(mean)) if known else 0.0))
    return sliding


def _on_scale(v: np.ndarray) -> np.ndarray:
    """Return asinh(v/s), with s well above the noise of the slower half of moving samples."""
    moving = np.abs(v[v != 0.0])
    if not moving.size:
        return v
    slow = np.flatnonzero((np.abs(v) <= np.median(moving)) & (v != 0.0))
    changes = np.diff(v[slow])[np.diff(slow) == 1]
    noise = noise_of(changes) if changes.size else 0.0
    return np.arcsinh(v / max(LINEAR_NOISE_RATIO * noise, MIN_LINEAR_SHARE * float(moving.max())))


def _step_between(
    record: Record, name: str, one: _Stretch, two: _Stretch, window: float | None
) -> MeasuredStep:
    """Return the step from one stretch to the next; backward sliding counts as forward."""
    before, after = one.where, two.where
    t, friction = record.time, record.friction
    last, first = t[before.stop - 1], t[after.start]
    start, end = 0.5 * (last + first), after.stop
    if window is not None:
        end = min(end, int(np.searchsorted(t, start + window, side="right")))
    if end - after.start < MIN_STRETCH_SAMPLES:
        raise UserError(
            f"fit {name}: {max(end - after.start, 0)} samples within {window:g} s of the step; a "
            f"fit needs {MIN_STRETCH_SAMPLES}: give a longer --window"
        )
    half = slice((before.start + before.stop) // 2, before.stop)
    reverse = friction[before].mean() < 0.0 and friction[after].mean() < 0.0
    friction = -friction if reverse else friction
    return MeasuredStep(
        name=name,
        v1=abs(float(record.velocity[before].mean())),
        v2=abs(float(record.velocity[after].mean())),
        change=float(first - last),
        before=friction[half],
        before_time=t[half] - start,
        time=t[after.start : end] - start,
        after=friction[after.start : end],
    )


def _no_step(record: Record, stretches: list[_Stretch]) -> str:
    """Return why a record holds no velocity step, and what to do with the motion it holds."""
    v, signs = record.velocity, {stretch.sign for stretch in stretches}
    one_way = np.ptp(v) > 0.0 and (np.all(np.diff(v) >= 0.0) or np.all(np.diff(v) <= 0.0))
    motions = {
        "it holds slides and rests at v = 0: for slide-hold-slide run segments slide and hold": (
            0.0 in signs and len(signs) > 1
        ),
        "it slides to and fro: run that motion as a programme": len(signs) > 1,
        "its column changes one way only, as a displacement does: give --displacement": (
            one_way and not record.is_named
        ),
        "its velocity is a ramp: run that motion as a programme": one_way,
        "its velocity is constant; if the load steps, run a study of several grid.normal_force": (
            len(stretches) == 1
        ),
    }
    known = next((f"; {motion}" for motion, holds in motions.items() if holds), "")
    return (
        f"fit {record.name}: holds no velocity step: no two stretches of {MIN_STRETCH_SAMPLES} "
        f"samples or more at velocities {100 * MIN_LOG_VELOCITY_CHANGE:g} % apart{known}"
    )


def constant_stretches(values: np.ndarray) -> list[slice]:
    """Return the stretches in which values are constant up to noise, in order.

    The values are cut where a cut reduces their scatter most, and each part is cut again as long as
    the means on both sides differ. Parts that are short or have a trend belong to a gradual change
    and are left out. Neighbours with equal means are merged.
    """
    noise = noise_of(np.diff(values))
    open_parts, done = [(0, values.size)], []
    while open_parts:
        start, stop = open_parts.pop()
        cut = _cut(values[start:stop], noise)
        if cut is None:
            done.append(slice(start, stop))
        else:
            open_parts += [(start, start + cut), (start + cut, stop)]
    parts = []
    for part in sorted(done, key=lambda part: part.start):
        samples = values[part]
        place = np.linspace(-0.5, 0.5, samples.size)
        most = max(MIN_LOG_VELOCITY_CHANGE, MAX_CHANCE_ERRORS * noise / np.sqrt(place @ place))
        if samples.size >= MIN_STRETCH_SAMPLES and abs(place @ samples / (place @ place)) < most:
            parts.append(part)
    joined: list[slice] = []
    for part in parts:
        if (
            joined
            and abs(values[part].mean() - values[joined[-1]].mean()) < MIN_LOG_VELOCITY_CHANGE
        ):
            joined[-1] = slice(joined[-1].start, part.stop)
        else:
            joined.append(part)
    return joined


def _cut(values: np.ndarray, noise: float) -> int | None:
    """Return the number of values before the best cut, or None if the means hardly differ there."""
    n = values.size
    if n < 2:
        return None
    left = np.arange(1, n)
    sums = np.cumsum(values)
    difference = (sums[-1] - sums[:-1]) / (n - left) - sums[:-1] / left
    weight = left * (n - left) / n
    best = int(np.argmax(weight * difference**2))
    least = max(MIN_LOG_VELOCITY_CHANGE, MIN_MEAN_ERRORS * noise / np.sqrt(weight[best]))
    return best + 1 if abs(difference[best]) > least else None
