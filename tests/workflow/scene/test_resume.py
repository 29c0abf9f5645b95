"""A programme that goes on where another ended, to the bit."""

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from tests.workflow.scene.scenes import heights, run, slide

STEPS = {"trace": 1}
ASKED = {"quantities": ["trace", "state"], "numerics": STEPS}


@pytest.fixture(scope="module")
def first():
    """Return the first half of a programme."""
    return run(slide(0.1, 32), **ASKED)


def test_two_halves_are_the_whole_to_the_bit(first):
    second = run(slide(0.1, 32), **ASKED, state=first)
    whole = run(slide(0.1, 32), slide(0.1, 32), **ASKED)
    for name in ("trace_mu", "trace_indentation", "trace_contact_fraction"):
        assert np.array_equal(second[name].values[1:], whole[name].values[33:]), name
    for name in ("state_memory", "state_p", "state_d", "state_position"):
        assert np.array_equal(second[name].values, whole[name].values), name
    assert second.trace_time.values[1:] == pytest.approx(whole.trace_time.values[33:], rel=1e-12)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"profile": 1.1 * heights()}, "belongs to another line"),
        ({"material": {"shear_modulus": 2e6, "relaxation_time": 1e-3}}, "another line, material"),
        ({"seed": 3}, "seed"),
    ],
)
def test_a_state_of_another_scene_is_refused(first, changed, words):
    with pytest.raises(UserError, match=words):
        run(slide(), **ASKED, state=first, **changed)


def test_a_dataset_without_state_is_refused():
    with pytest.raises(UserError, match='state: holds no state_memory; ask for the quantity "sta'):
        run(slide(), **ASKED, state=run(slide()))
