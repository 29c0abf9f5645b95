"""How much of a line is computed: as much as the kernels do."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import Line, amplitudes, draw_phases, rms_slope
from elastomer_friction.kernels.model.steady import steady_sliding
from elastomer_friction.kernels.motion.stretches import touchable
from elastomer_friction.kernels.quick.contacts.refined import MOST_SAMPLES
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from elastomer_friction.workflow.plan.cost.work import begun_anew, fine_samples, touchable_share
from elastomer_friction.workflow.simulate.tasks import Problem
from tests.workflow.plan.cost.problems import PROBLEMS

SIZES = 1000, 1_000_000


def test_what_would_take_too_many_fine_samples_is_not_refined():
    few, many = (fine_samples(Problem(0.2, n, 0.1, 30.0, 1.2), 8.0 * n, 0.5, 3.0) for n in SIZES)
    assert 8.0 * SIZES[0] < few
    assert many < 0.1 * MOST_SAMPLES


@given(st.floats(0.0, 1.0), st.floats(1e-6, 1e3), st.floats(1e-4, 1e4))
def test_a_share_is_a_share(hurst, load, viscous_pressure):
    assert 0.0 < touchable_share(hurst, load, viscous_pressure) <= 1.0


def states(count=40, elements=1000, steps=4):
    """Yield (H, Fbar, viscous pressure, touchable share) of random problems."""
    rng = np.random.default_rng(8)
    for _ in range(count):
        hurst, load, speed = rng.uniform(0, 1), 10 ** rng.uniform(-3, 0.5), 10 ** rng.uniform(0, 2)
        amplitude = amplitudes(hurst, elements)
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        law = SCHEMES["exponential"](1.0 / (steps * speed))
        (_, d), _ = steady_sliding(law, line.z, load * line.z.size)
        start, stop = touchable(line.z, 1.02 * d)
        share = np.sum(stop - start) / line.z.size
        yield hurst, load, speed * rms_slope(amplitude, elements), share


def test_shares_are_those_of_the_kernels():
    share = [np.log(row[3] / touchable_share(*row[:3])) for row in states()]
    assert np.median(np.abs(share)) < np.log(1.5)
    assert abs(np.mean(share)) < np.log(1.3)


@given(PROBLEMS, st.sampled_from([1, 4, 6, 64]))
def test_fine_samples_are_never_more_than_are_taken(problem, m):
    assert 0.0 <= fine_samples(problem, m * problem.elements, 0.5, 3.0) <= MOST_SAMPLES


def test_marches_begin_anew_near_h_of_one_at_high_speed():
    often, seldom = (begun_anew(Problem(h, 1e4, 1.0, 1e6, 1.2)) for h in (1.0, 0.5))
    assert often > 2.4 > 1.01 > max(seldom, begun_anew(Problem(1.0, 1e4, 1.0, 9.0, 1.2)))
