"""Records are parted where their velocity changes: at once, slowly, with noise, several times."""

from itertools import pairwise

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.laboratory.record import constant_stretches, measured_steps
from tests.workflow.laboratory.given import noise, record


def test_one_step_is_taken_apart():
    (step,) = measured_steps(record(n=100, span=1.0))
    assert (step.name, step.v1, step.v2) == ("r0.txt", pytest.approx(0.1), pytest.approx(0.12))
    assert step.ratio == pytest.approx(1.2)
    assert step.change == pytest.approx(0.01)
    assert (step.before.size, step.after.size) == (50, 100)
    np.testing.assert_allclose(step.time[:2], [0.005, 0.015])


@pytest.mark.parametrize("size", [0.0, 3e-3, 2e-2])
@pytest.mark.parametrize("ramp", [0, 30])
def test_stretches_of_noisy_velocities_with_slow_changes(size, ramp):
    levels = [1.0, 1.3, 1.0, 0.1]
    parts = [np.full(200, levels[0])]
    for one, two in pairwise(levels):
        parts += [np.linspace(one, two, ramp + 2)[1:-1], np.full(200, two)]
    values = np.log(np.concatenate(parts)) + noise(1, 800 + 3 * ramp, size)
    found = constant_stretches(values)
    assert len(found) == 4
    for i, stretch in enumerate(found):
        start = i * (200 + ramp)
        assert abs(stretch.start - start) <= 8
        assert abs(stretch.stop - start - 200) <= 8


def test_steps_of_one_file_are_numbered_and_a_window_cuts_them():
    one = record(n=100, span=1.0)
    v = np.concatenate([one.velocity, 0.1 + 0 * one.velocity])
    t = np.concatenate([one.time, one.time + 2.0])
    twice = one._replace(time=t, velocity=v, friction=np.tile(one.friction, 2))
    steps = measured_steps(twice, window=0.5)
    assert [step.name for step in steps] == ["r0.txt, step 1", "r0.txt, step 2"]
    assert [step.time.size for step in steps] == [50, 50]


def test_what_has_no_step_or_too_few_samples_is_refused():
    with pytest.raises(UserError, match=r"^fit r0\.txt: holds no velocity step: no two stretches"):
        measured_steps(record(v=(0.1, 0.1005)))
    with pytest.raises(UserError, match=r"^fit r0\.txt: 5 samples within 0\.05 s of the step"):
        measured_steps(record(n=100, span=1.0), window=0.05)
