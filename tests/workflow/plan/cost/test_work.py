"""The cost model: additive, increasing, and true in what does not depend on a machine."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernels import Line, Quantities, amplitudes, draw_phases, rms_slope
from kernels.motion.stretches import touchable
from kernels.rheology.kelvin import SCHEMES
from kernels.steady.plain import steady_sliding
from workflow.plan.cost.work import (
    TYPICAL,
    SecondsBySize,
    Work,
    sweeps,
    touchable_share,
    work_seconds,
)
from workflow.simulate.tasks import Problem, Recording

CURVE = SecondsBySize((10.0, 100.0, 1000.0), (2.0, 8.0, 80.0))
ALL = Quantities()


def seconds(elements=2500, march_steps=100, asked=ALL, timings=TYPICAL):
    """Return the predicted time of a task."""
    problem = Problem(0.7, elements, 0.05, 1.0, 1.2)
    return work_seconds(timings, asked, Work(problem, 4, march_steps), Recording(64))


def test_a_curve_passes_through_what_was_measured():
    assert [CURVE(size) for size in CURVE.sizes] == pytest.approx(CURVE.seconds)
    assert CURVE(math.sqrt(1000.0)) == pytest.approx(4.0)  # a power law in between
    assert CURVE(1.0) == pytest.approx(2.0)  # what a call takes at least
    assert CURVE(2000.0) == pytest.approx(160.0)


@given(st.floats(1.0, 1e7), st.floats(1.0, 4.0))
def test_more_samples_never_take_less_time(size, factor):
    assert CURVE(size * factor) >= CURVE(size) * (1.0 - 1e-12)


@pytest.mark.parametrize(
    "less",
    [
        {"elements": 1250},
        {"march_steps": 50},
        {"asked": ALL._replace(jump=False)},
        {"asked": ALL._replace(steady=False, relaxation=False)},
    ],
)
def test_more_work_takes_more_time(less):
    assert seconds() > seconds(**less)


def test_a_machine_of_half_the_speed_takes_twice_the_time():
    *curves, case = TYPICAL
    slow = [c._replace(seconds=tuple(2.0 * s for s in c.seconds)) for c in curves]
    assert seconds(timings=type(TYPICAL)(*slow, 2.0 * case)) == pytest.approx(2.0 * seconds())


@given(st.floats(0.0, 1.0), st.floats(1e-6, 1e3), st.floats(1e-4, 1e4))
def test_a_share_is_a_share(hurst, load, viscous_pressure):
    assert 0.0 < touchable_share(hurst, load, viscous_pressure) <= 1.0
    assert 1.0 <= sweeps(load, viscous_pressure) <= 8.0


def states(count=40, elements=1000, steps=4):
    """Yield (H, Fbar, viscous pressure, touchable share, sweeps) of random problems."""
    rng = np.random.default_rng(8)
    for _ in range(count):
        hurst, load, speed = rng.uniform(0, 1), 10 ** rng.uniform(-3, 0.5), 10 ** rng.uniform(0, 2)
        amplitude = amplitudes(hurst, elements)
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        law = SCHEMES["exponential"](1.0 / (steps * speed))
        (_, d), number = steady_sliding(law, line.z, load * line.z.size)
        start, stop = touchable(line.z, 1.02 * d)
        share = np.sum(stop - start) / line.z.size
        yield hurst, load, speed * rms_slope(amplitude, elements), share, number


def test_shares_and_sweeps_are_those_of_the_kernels():
    found = list(states())
    share = [np.log(row[3] / touchable_share(*row[:3])) for row in found]
    sweep = [np.log(row[4] / sweeps(*row[1:3])) for row in found]
    assert np.median(np.abs(share)) < np.log(1.5)
    assert abs(np.mean(share)) < np.log(1.3)
    assert np.median(np.abs(sweep)) < np.log(1.4)
