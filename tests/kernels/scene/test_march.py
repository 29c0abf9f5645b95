"""March of all elements through programmes, against other marches, schemes and finer steps."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, march, steady_sliding
from elastomer_friction.kernels.motion.legs import Hold, Ramp, Slide
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from tests.convergence import observed_order
from tests.kernels.scene.given import MATERIALS, a_line, trace
from tests.sizes import size


def after_a_jump(scheme, ratio, steps):
    """Return (mu, indentation) of Kelvin elements by ``run_scene`` and by ``march``."""
    line = a_line()
    n, m = line.z.size, line.steps_per_spacing
    before, after = (SCHEMES[scheme](1.0 / (m * v)) for v in (0.5, 0.5 * ratio))
    state, _ = steady_sliding(before, line.z, 0.3 * n)
    numbers = np.arange(1, steps + 1)
    weight = lagged_slope(line.slope, after.lag)
    control = ConstantForce(0.3 * n)
    mu, d, _, _ = march(after, control, line.z, weight, state, numbers, np.inf)
    # The first step, at the old speed, stays in the steady state.
    programme = (Slide(0.5, 1.0 / m), Slide(0.5 * ratio, numbers.size / m))
    result = trace(line, programme, KELVIN, scheme=scheme)
    acting = d + after.lag * (np.append(state.d, d[:-1]) - d)
    return (result["trace_mu"][2:], result["trace_indentation"][2:] - line.datum), (mu, acting)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("ratio", [0.6, 1.6])
def test_kelvin_elements_after_a_jump_follow_the_march_to_rounding(scheme, ratio):
    (mu, indentation), marched = after_a_jump(scheme, ratio, size(600, 60))
    np.testing.assert_allclose(mu, marched[0], rtol=0, atol=1e-13)
    np.testing.assert_allclose(indentation, marched[1], rtol=1e-13)


def gaps_of_schemes(name, refinements, seeds):
    """Return rms differences of mu(t) between both schemes, shape (refinements, seeds).

    Over a start from rest, a hold, a reversal and a ramp. They share only the contact step.
    """
    programme = (
        Slide(4.0, 2.0),
        Hold(1.0),
        Slide(4.0, 1.3),
        Slide(-6.0, 2.0),
        Ramp(2.0, 16.0, 0.3),
    )
    gaps = np.empty((len(refinements), seeds))
    for k, m in enumerate(refinements):
        for seed in range(seeds):
            line = a_line(size(20, 8), 1.0, m, seed)
            one, two = (
                trace(line, programme, MATERIALS[name], start="relaxed", scheme=scheme)["trace_mu"]
                for scheme in FORMS_BY_SCHEME
            )
            gaps[k, seed] = np.sqrt(np.mean((one - two) ** 2))
    return gaps


@pytest.mark.parametrize("name", ["solid", "prony"])
def test_both_schemes_agree_at_second_order(name):
    refinements = np.array([8, 16, 32])[: size(3, 2)]
    gaps = gaps_of_schemes(name, refinements, size(2, 1))
    assert observed_order(refinements, gaps) > size(1.5, 0.5)
    assert gaps[-1].max() < size(1e-3, 1e-1)


def errors_over_time(name, refinements):
    """Return rms errors of mu(t) over its rms, shape (refinements, lines).

    The line starts from rest and has a velocity step. The reference has four times finer steps.
    """
    curves, lines = [], size(3, 1)
    for m in (*refinements, 4 * refinements[-1]):
        programme = (Slide(2.0, 8.0), Slide(3.0, 8.0))
        for seed in range(lines):
            line = a_line(8, 1.0, m, seed)
            result = trace(line, programme, MATERIALS[name], start="relaxed")
            at = np.linspace(0.25, 6.5, 400)
            curves.append(np.interp(at, result["trace_time"], result["trace_mu"]))
    result = np.array(curves).reshape(-1, lines, 400)
    return np.sqrt(
        np.mean((result[:-1] - result[-1]) ** 2, axis=2) / np.mean(result[-1] ** 2, axis=1)
    )


@pytest.mark.parametrize("name", MATERIALS)
def test_friction_over_time_converges_at_second_order(name):
    refinements = np.array([4, 8, 16])[: size(3, 2)]
    errors = errors_over_time(name, refinements)
    assert observed_order(refinements, errors) > size(1.4, 0.8)
    assert errors[-1].max() < size(1e-2, 0.1)
