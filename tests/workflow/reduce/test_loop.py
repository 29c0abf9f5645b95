"""Loops of the last cycle: response and work of traces that are known."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Oscillation, Ramp, Sampled, Slide
from elastomer_friction.workflow.reduce.traces import leg_duration, loop

PROGRAMME = (Slide(2.0, 3.0), Hold(0.7), Oscillation(0.0, 0.4, 0.5, 3))
START, PERIOD = 2.2, 2.0


def cycles(count, mean=0.0):
    """Return times, phases and the displacement of three cycles, ``count`` samples each."""
    time = START + PERIOD * np.arange(1, 3 * count + 1) / count
    phase = math.pi * (time - START)
    return time, phase


@pytest.mark.parametrize("count", [16, 64])
def test_the_response_in_the_last_cycle_is_found(count):
    time, phase = cycles(count)
    decay = np.where(time < START + 2.0 * PERIOD, 3.0, 1.0)  # earlier cycles do not count
    mu = decay * (0.3 * np.sin(phase) + 0.2 * np.cos(phase) + 0.05 * np.sin(3.0 * phase) + 0.7)
    found = loop(PROGRAMME, time[None], mu[None], mu[None])
    assert found.mu_in_phase[0] == pytest.approx(0.3, rel=1e-9)
    assert found.mu_quadrature[0] == pytest.approx(0.2, rel=1e-9)
    assert found.loop_work[0] == pytest.approx(math.pi * 0.4 * 0.2, rel=1e-9)


def test_work_is_that_of_a_force_along_the_whole_way():
    programme = (Oscillation(1.5, 0.1, 2.0, 2),)
    time = np.arange(1, 33) / 32.0
    found = loop(programme, time[None], np.ones((2, 32)), np.ones((2, 32)))
    assert found.loop_work == pytest.approx([0.75, 0.75])  # force times mean speed times period


def test_without_an_oscillation_or_samples_there_is_nothing():
    time, phase = cycles(16)
    assert np.isnan(loop(PROGRAMME[:2], time[None], phase[None], phase[None])).all()
    assert np.isnan(loop(PROGRAMME, time[None, :5], phase[None, :5], phase[None, :5])).all()


def test_every_leg_takes_its_time():
    legs = (Slide(-2.0, 3.0), Hold(4.0), Ramp(0.0, 1.0, 5.0), Oscillation(0, 1, 0.5, 3))
    assert [leg_duration(leg) for leg in legs] == [1.5, 4.0, 5.0, 6.0]
    assert leg_duration(Sampled((0.0, 2.0, 7.0), (1.0, 1.0, 0.0))) == 7.0
