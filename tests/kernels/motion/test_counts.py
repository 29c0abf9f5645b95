"""Numbers of steps are computed without the steps: exactly, or as a close upper bound."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels.motion.counts import count_steps
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Ramp, Sampled, Slide, steps_of
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from elastomer_friction.kernels.scene.scene_case import SceneCase, scene_steps

SPEEDS = st.sampled_from([-3.0, -0.7, 0.01, 1.0, 40.0])
SPANS = st.floats(1e-3, 30.0)
EXACT = st.one_of(
    st.builds(Slide, SPEEDS, SPANS),
    st.builds(Hold, SPANS),
    st.builds(Oscillation, st.just(0.0), st.floats(1e-3, 0.2), st.just(1.0), st.integers(1, 5)),
)
BOUNDED = st.one_of(
    st.builds(Ramp, SPEEDS, SPEEDS, SPANS),
    st.builds(Oscillation, SPEEDS, st.floats(0.5, 9.0), st.just(1.0), st.integers(1, 5)),
    st.builds(
        lambda speeds: Sampled(tuple(map(float, range(len(speeds)))), tuple(speeds)),
        st.lists(st.sampled_from([0.0, 0.0, -2.0, 1.0, 7.0]), min_size=3, max_size=8),
    ),
)


def counted(programme, m, position):
    """Return the number of steps of each leg, counted from the steps."""
    return np.bincount(steps_of(programme, m, position).leg, minlength=len(programme))


@given(st.lists(EXACT, min_size=1, max_size=5), st.sampled_from([1, 4, 7]), st.floats(0.0, 1.0))
def test_slides_holds_and_small_oscillations_are_counted(programme, m, position):
    wanted = counted(tuple(programme), m, position)
    np.testing.assert_array_equal(count_steps(tuple(programme), m, position), wanted)


@given(BOUNDED, st.sampled_from([1, 4]))
def test_other_paths_take_no_more_than_the_bound_and_not_far_less(leg, m):
    if isinstance(leg, Sampled) and not any(leg.speeds):
        return
    (bound,), (steps,) = count_steps((leg,), m), counted((leg,), m, 0.0)
    pieces = 3 * getattr(leg, "cycles", 1) if isinstance(leg, Oscillation) else 20
    assert steps <= bound <= steps + pieces * max(64, 16 * m) * 4


def test_a_programme_of_too_many_steps_is_refused_before_they_are_made():
    long = (Slide(1.0, 1e12), Hold(1.0))
    assert count_steps(long, 4)[0] == 4e12
    nothing = np.empty(0)
    scene = SceneCase(
        KELVIN, "exponential", long, 1.0, None, "steady", (), nothing, nothing, nothing
    )
    with pytest.raises(ValueError, match=r"takes up to 4e\+12 steps, more than 1e\+07"):
        scene_steps(scene, 4)
