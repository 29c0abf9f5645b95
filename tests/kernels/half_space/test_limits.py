"""Limits of the half-space: full contact and the foundation of independent elements."""

import numpy as np
import pytest

from elastomer_friction.kernels.half_space.body import HalfSpace, Step, step_tolerance, take_step
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.sliding_body import slide_steadily
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.half_space.waves import two_sided, wave_numbers
from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.model.contact import solve_indentation
from elastomer_friction.kernels.model.friction import lagged_slope, mean_slope, step_average
from elastomer_friction.kernels.model.steady import steady_sliding as steady_line
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.kelvin import exponential
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum, complex_modulus
from elastomer_friction.kernels.velocity_step.case import Case, Quantities
from elastomer_friction.kernels.velocity_step.cases import run_case as run_foundation
from elastomer_friction.workflow.simulate.drawing import line_generator
from tests.sizes import PLAIN_PYTHON

BRANCHES = Spectrum((2.0, 5.0), (0.5, 4.0), 0.0)
BOTH = Spectrum((2.0, 5.0), (0.5, 4.0), 10.0)
STEPS = np.array([1, 2, 5, 13])


def rough(elements: int, m: int, cutoff: int = 0, seed: int = 1) -> Surface:
    amplitudes = ring_amplitudes(0.7, elements, cutoff=cutoff)
    return Surface.drawn(np.random.default_rng(seed), amplitudes, elements, m)


def closed_friction(surface: Surface, spectrum: Spectrum, speed: float, load: float) -> float:
    """Return mu in full contact: sum (|q|/2) q_x E''(q_x v) |h_q|^2 over the mean pressure."""
    m, shape = surface.steps_per_spacing, surface.z.shape
    q_y, q_x = wave_numbers(shape, m)
    power = np.abs(np.fft.rfft2(surface.z) / surface.z.size) ** 2 * two_sided(shape)
    loss = complex_modulus(spectrum, q_x * speed).imag
    return float(np.sum(0.5 * np.hypot(q_y, q_x) * q_x * loss * power)) / (load * m / shape[1])


@pytest.mark.parametrize(
    ("spectrum", "least"),
    [
        (KELVIN, 1.9),
        (BRANCHES, 1.9),
        (BOTH, 1.6),
    ],  # with a dashpot, branches reach second order only for fine steps (prony.py)
    ids=["kelvin", "branches", "both"],
)
def test_friction_in_full_contact_is_the_closed_form_to_second_order(
    spectrum: Spectrum, least: float
) -> None:
    errors = []
    for m in (8, 16, 32):
        surface, load = rough(8, m, cutoff=2), 100.0
        result = run_case(surface, Case(load, 0.4, (), (), "exponential", spectrum), Quantities())
        assert result.contact_fraction == 1.0
        closed = closed_friction(surface, spectrum, 0.4, load)
        assert result.mu_1 == pytest.approx(closed, rel=1e-9)
        space = HalfSpace.under(form_of(spectrum, "exponential"), surface, load)
        errors.append(slide_steadily(space, spectrum, 0.4).step_mu / closed - 1.0)
    orders = np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))
    assert np.abs(errors[-1]) < 1e-3
    assert orders[-1] > least


def line_and_surfaces() -> tuple[Line, list[Surface]]:
    """Return a line and surfaces that are uniform across it: a single row and a square."""
    amplitude = np.array([1.0, 0.5, 0.3, 0.2, 0.0, 0.0, 0.0, 0.0])
    line = Line.self_affine(amplitude, np.arange(8.0), 16, 4)
    fields = [(line.z + line.datum)[None], line.slope[None]]
    return line, [
        Surface.from_samples(*(np.tile(field, (rows, 1)) for field in fields), 4)
        for rows in (1, 64)
    ]


def equal_stiffness(surface: Surface, elements: int = 16) -> np.ndarray:
    """Return the stiffness 1/L for every wave, in place of |q|/2."""
    rows, n = surface.z.shape
    return np.full((rows, n // 2 + 1), 1.0 / elements)


@pytest.mark.parametrize("spectrum", [BRANCHES, BOTH], ids=["branches", "both"])
def test_a_half_space_of_equal_stiffness_is_the_foundation(spectrum: Spectrum) -> None:
    """Friction, indentation and relaxation agree with a line of elements with all branches.

    The initial rate agrees too; with a dashpot it is NaN because mu jumps.
    """
    line, surfaces = line_and_surfaces()
    case = Case(0.3, 0.7, (1.2, -0.8), (STEPS, STEPS), "exponential", spectrum, refine=False)
    requested = Quantities(initial_rate=True)
    foundation = run_foundation(line, case, requested)
    assert np.isnan(foundation.initial_rate).all() == (spectrum is BOTH)
    for surface in surfaces:
        result = run_case(surface, case, requested, equal_stiffness(surface))
        assert result.initial_rate == pytest.approx(foundation.initial_rate, rel=1e-5, nan_ok=True)
        space = HalfSpace.under(
            form_of(spectrum, "exponential"), surface, case.load, equal_stiffness(surface)
        )
        touching = slide_steadily(space, spectrum, case.speed).body.p > 0.0
        assert np.mean(touching) == foundation.contact_fraction
        assert result.indentation + case.load == pytest.approx(foundation.indentation, abs=1e-6)
        for curve, two, expected, settled in zip(
            result.curves, result.mu_2, foundation.curves, foundation.mu_2, strict=True
        ):
            assert np.allclose(curve - two, expected - settled, atol=1e-5)


def test_kelvin_elements_of_equal_stiffness_are_the_foundation() -> None:
    """Pressures and jumps of the line are summed over samples, as on the half-space."""
    line, surfaces = line_and_surfaces()
    load, speed, ratio = 0.3, 0.7, 1.2
    law = exponential(1.0 / (4 * speed))
    state, _ = steady_line(law, line.z, load * 64)
    mu = step_average(lagged_slope(line.slope, law.lag), line.z - state.w, state.d)
    touching = line.z - state.w < state.d
    instant = []
    for v in (speed, ratio * speed):
        threshold = line.z[touching] - v * line.slope[touching]
        rate, _ = solve_indentation(threshold, load * 64, 0.0)
        instant.append(mean_slope(np.maximum(rate - threshold, 0.0), line.slope[touching]))
    case = Case(load, speed, (ratio,), (STEPS,), "exponential")
    for surface in surfaces:
        result = run_case(surface, case, Quantities(), equal_stiffness(surface))
        space = HalfSpace.under(
            form_of(KELVIN, "exponential"), surface, load, equal_stiffness(surface)
        )
        sliding = slide_steadily(space, KELVIN, speed)
        assert sliding.step_mu == pytest.approx(mu, abs=1e-6)
        assert np.mean(sliding.body.p > 0.0) == np.mean(touching)
        assert result.mu_1 == pytest.approx(mu, rel=0.02)  # edges of the foundation are sharp
        assert 0.8 < result.contact_fraction / np.mean(touching) < 1.0
        assert result.indentation + load == pytest.approx(state.d + line.datum, abs=1e-6)
        assert result.jump[0] == pytest.approx(instant[1] - instant[0], abs=1e-6)


STEADY = [  # elements, seed, load, speed and material
    (8, 9, 0.1, 10.0 / np.pi, KELVIN),  # mu is equal at two instants, but not steady yet
    (8, 11, 0.05, 10.0 / np.pi, KELVIN),  # mu is constant until contacts return
    *(  # loss tangents up to 0.75, 2.7 and 8.6, for which the search converges slowly
        (16, 1, 1.0, 0.5 / np.sqrt(1.0 + modulus), Spectrum((modulus,), (1.0,), 0.0))
        for modulus in (3.0, 30.0, 300.0)
    ),
]


@pytest.mark.parametrize(("elements", "seed", "load", "speed", "spectrum"), STEADY)
def test_a_march_from_the_steady_state_stays_steady(elements, seed, load, speed, spectrum) -> None:
    surface = rough(elements, 4, seed=seed)
    space = HalfSpace.under(form_of(spectrum, "exponential"), surface, load)
    result = slide_steadily(space, spectrum, speed)
    body = result.body
    for _ in range(2 * surface.z.shape[1]):
        body, _ = take_step(space, body, result.step, 1e-9)
    assert mean_slope(body.p, result.step.weight) == pytest.approx(result.step_mu, rel=1e-5)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: hundreds of passes")
def test_few_passes_per_step_give_the_friction_of_many() -> None:
    """Runs are compared over 2.5 tau after a velocity step; first steps take more passes."""
    surface, speed = rough(32, 4), 10.0 / np.pi
    amplitudes = ring_amplitudes(0.7, 32)
    load = 0.3 * rms_slope_of(amplitudes, 32) * 32.0
    space = HalfSpace.under(form_of(KELVIN, "exponential"), surface, load)
    start = slide_steadily(space, KELVIN, speed).body
    step = Step.of(space.form, surface, 1.2 * speed)
    result, passes = [], []
    for tolerance in (step_tolerance(KELVIN, step.law), 1e-8):
        body, mu = start._replace(memory=start.memory.copy()), []
        for _ in range(30):
            body, used = take_step(space, body, step, tolerance)
            mu.append(mean_slope(body.p, step.weight))
            passes.append(used)
        result.append(np.array(mu))
    assert np.median(passes[:30]) <= 5
    np.testing.assert_allclose(*result, rtol=1e-4)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: 30 million samples")
def test_a_contact_with_stalling_directions_is_solved() -> None:
    """One of 1296 maps in the study bodies (H = 0.8, x = 30) took more than 20 000 passes."""
    surface = Surface.drawn(line_generator(3, 0.8, 32, 8), ring_amplitudes(0.8, 32, 2), 32, 4)
    case = Case(1.5, 9.60000000000582, (1.0,), (), "exponential")
    result = run_case(surface, case, Quantities(jump=False, relaxation=False))
    assert np.isfinite(result.mu_1)
    assert result.work < 6000 * surface.z.size


def test_units_that_decay_within_a_step_need_no_memory() -> None:
    """A case stores none for them; a march with the whole memory gives the same friction."""
    surface, spectrum = rough(16, 4), Spectrum((2.0, 5.0, 3.0), (1e-4, 0.5, 4.0), 0.0)
    case = Case(0.3, 0.7, (1.2,), (np.arange(1, 20),), "exponential", spectrum)
    result = run_case(surface, case, Quantities())
    space = HalfSpace.under(form_of(spectrum, "exponential"), surface, case.load)
    body = slide_steadily(space, spectrum, 0.7).body
    two = slide_steadily(space, spectrum, 1.2 * 0.7)
    assert two.step.law.decay.min() < 1e-17 < 1e-3 < np.sort(two.step.law.decay)[1]
    mu = []
    for _ in case.kept_steps[0]:
        body, _ = take_step(space, body, two.step)
        mu.append(mean_slope(body.p, two.step.weight) - two.step_mu)
    assert result.curves[0] - result.mu_2[0] == pytest.approx(np.array(mu), abs=1e-6)
