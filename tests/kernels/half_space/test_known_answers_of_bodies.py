"""Published solutions of contacts and friction: Hertz, Westergaard, spheres, cylinders, losses.

Sources: K. L. Johnson, Contact Mechanics (Cambridge, 1985), ch. 4 and 13; K. L. Johnson,
J. A. Greenwood, J. G. Higginson, Int. J. Mech. Sci. 27, 383 (1985); G. Wang and K. Knothe,
Int. J. Solids Struct. 30, 1635 (1993); G. Carbone and C. Putignano, J. Mech. Phys. Solids 61,
1822 (2013).
"""

import numpy as np
import pytest

from elastomer_friction.kernels.half_space.body import HalfSpace, at_samples
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.sliding_body import SlidingBody, slide_steadily
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.half_space.waves import (
    half_space_stiffness,
    two_sided,
    wave_numbers,
)
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.law import displacement
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum, complex_modulus
from elastomer_friction.kernels.velocity_step.case import Case, Quantities
from tests.kernels.half_space.test_limits import BRANCHES, rough

STEADY = Quantities(jump=False, relaxation=False)


def centred(n: int) -> np.ndarray:
    """Return distances from the midpoint between the two central samples, in samples."""
    return np.arange(n) - 0.5 * (n - 1)


def sphere(n: int, side: float, radius: float = 1.0) -> Surface:
    """Return the surface (x^2 + y^2)/(2 R) on n x n elements; lengths in the unit of side."""
    x = centred(n) * side / n
    z = (x[:, None] ** 2 + x[None, :] ** 2) / (2.0 * radius)
    return Surface.from_samples(z, np.broadcast_to(x / radius * side / n, z.shape), 1)


def elastic_loss(p: np.ndarray, m: int, loss) -> float:
    """Return the sum of (|q|/2) q_x loss(q_x) |u_q|^2 over the mean pressure, u = -A p."""
    _, q_x = wave_numbers(p.shape, m)
    stiffness = half_space_stiffness(p.shape, m)
    stiffness[0, 0] = np.inf
    power = np.abs(np.fft.rfft2(p) / p.size / stiffness) ** 2 * two_sided(p.shape)
    stiffness[0, 0] = 0.0
    return float(np.sum(stiffness * q_x * loss(q_x) * power)) / float(p.mean())


def test_a_sphere_has_the_pressures_of_hertz() -> None:
    """The side is 10 contact radii; the radius of the sphere and E* are 1."""
    errors = []
    for n in (32, 64, 128):
        side, a = 10.0, 1.0
        surface = sphere(n, side)
        force, peak = 4.0 / 3.0 * a**3, 2.0 / np.pi * a
        operator = Operator.of(half_space_stiffness((n, n), 1) * n / side, n)
        p = press(surface.z, force / side**2, operator, None, 1e-7).p
        x = centred(n) * side / n
        r2 = x[:, None] ** 2 + x[None, :] ** 2
        expected = peak * np.sqrt(np.maximum(1.0 - r2, 0.0))
        errors.append(np.abs(p - expected)[r2 < 0.25].max() / peak)
    assert errors[2] < 0.5 * errors[0]
    assert errors[2] < 0.01


def test_a_wave_has_the_pressures_of_westergaard() -> None:
    """A map of one row is a line contact in plane strain."""
    errors = []
    for n in (64, 256):
        x = centred(n) / n
        z = -np.cos(2.0 * np.pi * x)
        stiffness = half_space_stiffness((1, n), 1) * n
        edge = np.pi * 0.2  # pi a/lambda
        mean = np.pi * np.sin(edge) ** 2
        p = press(z[None], mean, Operator.of(stiffness, n), None, 1e-8).p
        inside = np.maximum(np.sin(edge) ** 2 - np.sin(np.pi * x) ** 2, 0.0)
        expected = 2.0 * mean * np.cos(np.pi * x) / np.sin(edge) ** 2 * np.sqrt(inside)
        errors.append(np.abs(p[0] - expected).mean() / mean)
    assert errors[1] < 0.25 * errors[0]
    assert errors[1] < 0.005


@pytest.mark.parametrize(("share", "full"), [(1.001, True), (0.999, False)])
def test_two_waves_close_at_the_pressure_of_johnson_greenwood_and_higginson(
    share: float, full: bool
) -> None:
    n, height = 64, 0.3
    x = 2.0 * np.pi * np.arange(n) / n
    z = height * np.cos(x)[:, None] * np.cos(x)[None, :]  # two waves of wavelength 1/sqrt 2
    wavelength = 1.0 / np.sqrt(2.0)
    mean = share * np.pi * height / wavelength
    p = press(z, mean, Operator.of(half_space_stiffness((n, n), 1) * n, n), None, 1e-8).p
    assert (p.min() > 0.0) == full


def test_slow_friction_is_the_loss_of_the_elastic_contact() -> None:
    """mu/(v tau) is 1/R for a sphere, and that of the march for a rough surface."""
    errors = []
    for n in (64, 128):
        side = 6.0
        surface = sphere(n, side)
        operator = Operator.of(half_space_stiffness((n, n), 1) * n / side, n)
        p = press(surface.z, 4.0 / 3.0 / side**2, operator, None, 1e-7).p
        errors.append(elastic_loss(p, 1, lambda q: q) * (n / side) - 1.0)
    assert np.abs(errors[1]) < 0.6 * np.abs(errors[0]) < 0.1
    surface, load, speed = rough(16, 8), 0.1, 0.1 / np.pi
    operator = Operator.of(half_space_stiffness(surface.z.shape, 8), surface.z.shape[1])
    p = press(surface.z, load / 16, operator, None, 1e-7).p
    mu = run_case(surface, Case(load, speed, (), (), "exponential"), STEADY).mu_1
    assert elastic_loss(p, 8, lambda q: q * speed) == pytest.approx(mu, rel=0.04)


def steadily(surface: Surface, load: float, speed: float, spectrum: Spectrum) -> SlidingBody:
    space = HalfSpace.under(form_of(spectrum, "exponential"), surface, load)
    return slide_steadily(space, spectrum, speed)


@pytest.mark.parametrize(
    ("time", "peak"), [(1e-9, 60.32), (0.009, 78.74), (0.045, 84.72), (2.0, 85.31)]
)
def test_rolling_cylinders_have_the_pressures_of_wang_and_knothe(time: float, peak: float) -> None:
    """Two of R = 100 mm, G = 1143 N/mm^2, nu = 0.4, f = 1, as one of E*/2; 600 N/mm, 1000 mm/s."""
    n, dx, radius, stiffness = 1024, 0.25, 50.0, 0.5 * 2.0 * (1143.0 / 2.0) / (1.0 - 0.4)
    x = centred(n) * dx
    surface = Surface.from_samples((x**2 / (2.0 * radius))[None], (x / radius * dx)[None], 1)
    spectrum = Spectrum((1.0,), (time / 2.0,), 0.0)
    result = steadily(surface, 600.0 / stiffness, 1000.0 / dx, spectrum)
    assert result.body.p.max() * stiffness / dx == pytest.approx(peak, rel=0.005)


@pytest.mark.parametrize("spectrum", [KELVIN, BRANCHES], ids=["kelvin", "branches"])
def test_the_work_of_friction_is_the_dissipation(spectrum: Spectrum) -> None:
    """The dissipation, a sum over modes of displacements, agrees to discretization errors."""
    apart = []
    for m in (4, 8):
        surface = rough(16, m)
        result = steadily(surface, 0.3, 0.5, spectrum)
        assert min(result.mu, result.step_mu) > 0.0
        u = result.body
        n = surface.z.shape[1]
        depth = -np.fft.rfft2(displacement_of(spectrum, u, surface)) / surface.z.size
        q_y, q_x = wave_numbers(surface.z.shape, m)
        loss = complex_modulus(spectrum, q_x * 0.5).imag
        power = np.abs(depth) ** 2 * two_sided((n, n))
        lost = np.sum(0.5 * np.hypot(q_y, q_x) * q_x * loss * power) / (0.3 / 16)
        apart.append(abs(lost / result.step_mu - 1.0))
    assert max(apart) < 0.02


def displacement_of(spectrum: Spectrum, body, surface: Surface) -> np.ndarray:
    form = form_of(spectrum, "exponential")
    u = displacement(form, body.memory, body.depth)
    return at_samples(u, body.offset, surface.z.shape)


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("speed", "side", "mu", "within"),
    [(0.106, 9.0, 0.00851, 0.07), (1.169, 12.0, 0.0403, 0.03), (7.943, 36.0, 0.0159, 0.03)],
)
def test_a_sphere_of_one_branch_has_the_friction_of_carbone_and_putignano(
    speed: float, side: float, mu: float, within: float
) -> None:
    """R = 1 cm, E = 1 MPa, nu = 0.3, one branch of 9 MPa and 1 ms, load 0.15 N.

    speed : v 10 ms/a_0. side : over a_0, the elastic contact radius.
    """
    radius, modulus, n = 0.01, 1e6 / (1.0 - 0.3**2), 512
    a = (3.0 * 0.15 * radius / (4.0 * modulus)) ** (1.0 / 3.0)
    surface = sphere(n, side * a, radius)
    dx = side * a / n
    load = 0.15 / (modulus * side * a)  # in m, like the heights
    result = steadily(surface, load, speed * a / 0.01 * 1e-3 / dx, Spectrum((9.0,), (1.0,), 0.0))
    assert result.mu / dx == pytest.approx(mu, rel=within)


@pytest.mark.exhaustive
def test_friction_does_not_depend_on_the_number_of_rolloff_lengths() -> None:
    """Sides of 1 and 4 roll-off lengths agree at one pressure, within the scatter of surfaces."""
    means = []
    for lengths, seeds in ((1, 16), (4, 4)):
        elements = 16 * lengths
        amplitudes = ring_amplitudes(0.7, elements, rolloff=float(lengths))
        slope = rms_slope_of(amplitudes, elements)
        case = Case(0.05 * slope * elements, 1.0 / np.pi, (), (), "exponential")
        mu = [
            run_case(
                Surface.drawn(np.random.default_rng(seed), amplitudes, elements, 4), case, STEADY
            ).mu_1
            for seed in range(seeds)
        ]
        means.append((np.mean(mu) / slope, np.std(mu) / slope / np.sqrt(seeds)))
    (one, error), (four, other) = means
    assert abs(one - four) < 4.0 * np.hypot(error, other)
    assert abs(one / four - 1.0) < 0.1
