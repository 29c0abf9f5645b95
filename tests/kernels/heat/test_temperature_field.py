"""The temperature field of the rubber's surface, compared with closed forms."""

import math

import numpy as np
import pytest
from scipy.special import wofz

from elastomer_friction.kernels.half_space.waves import wave_numbers
from elastomer_friction.kernels.heat.field import cold_content, heat, heated_surface, steady_heat

M, DIFFUSIVITY = 4, 0.7
SHAPE = (6, 8)


def surface_of(shape, dt, block=0.0, diffusivity=DIFFUSIVITY):
    return heated_surface(*wave_numbers(shape, M), diffusivity, block, dt)


def rates_of(surface, speed):
    """Return D q^2 - i q_x v of every mode, and 1 for the mean."""
    squares = surface.q_y[:, None] ** 2 + surface.q_x**2
    rates = surface.diffusivity * squares - 1j * surface.q_x * speed
    rates[0, 0] = 1.0
    return rates


def erf(z):
    return 1.0 - np.exp(-z * z) * wofz(1j * z)


@pytest.mark.parametrize("speed", [0.0, 3.0, -40.0])
@pytest.mark.parametrize("dt", [0.01, 0.5])
def test_waves_of_flux_at_rest_and_moving_warm_as_the_closed_form(speed, dt):
    surface = surface_of(SHAPE, 0.01)
    flux = np.fft.rfft2(np.random.default_rng(1).random(SHAPE))
    content, rates = cold_content(surface), rates_of(surface, speed)
    steady = math.sqrt(DIFFUSIVITY) * flux / np.sqrt(rates)
    for step in range(1, 41):
        content, rise = heat(surface, content, flux, speed * dt, dt)
        exact = steady * erf(np.sqrt(rates * step * dt))
        np.testing.assert_allclose(rise.ravel()[1:], exact.ravel()[1:], rtol=2e-4)
    final, rise = steady_heat(surface, flux, speed)
    np.testing.assert_allclose(rise.ravel()[1:], steady.ravel()[1:], rtol=1e-12)
    for _ in range(3):  # and it stays steady
        final, rise = heat(surface, final, flux, speed * dt, dt)
    np.testing.assert_allclose(rise.ravel()[1:], steady.ravel()[1:], rtol=1e-12)


def test_a_pattern_that_stops_cools_as_the_kernel_of_diffusion():
    surface, dt = surface_of(SHAPE, 0.01), 0.01
    flux = np.fft.rfft2(np.random.default_rng(2).random(SHAPE))
    content, _ = steady_heat(surface, flux, 5.0)
    rates, decay = rates_of(surface, 5.0), rates_of(surface, 0.0)
    for _ in range(20):
        content, rise = heat(surface, content, 0.0 * flux, 0.0, dt)
    # (1/pi) int exp(-(D q^2 + y) t)/(lambda + y) y^(-1/2) dy, lambda at the speed before the stop
    time = 20 * dt
    carried = math.sqrt(DIFFUSIVITY) * flux / np.sqrt(rates)
    exact = carried * np.exp((rates - decay) * time) * (1.0 - erf(np.sqrt(rates * time)))
    assert np.all(np.abs(rise - exact).ravel()[1:] <= 5e-4 * np.abs(carried).ravel()[1:])


def test_a_uniform_flux_warms_a_thick_block_as_a_half_space_and_a_thin_one_to_its_steady_value():
    flux = np.zeros((1, 5), complex)
    flux[0, 0] = 1.0
    thick, thin = surface_of((1, 8), 0.01, 8.0), surface_of((1, 8), 0.01, 0.3)
    content, warm = cold_content(thick), cold_content(thin)
    for step in range(1, 101):
        content, rise = heat(thick, content, flux, 0.1, 0.01)
        warm, final = heat(thin, warm, flux, 0.1, 0.01)
        root = 2.0 * math.sqrt(DIFFUSIVITY * 0.01 * step / math.pi)
        np.testing.assert_allclose(rise[0, 0], root, rtol=4e-4)
    np.testing.assert_allclose(final[0, 0], 0.3, rtol=1e-6)
    np.testing.assert_allclose(steady_heat(thick, flux, 1.0)[1][0, 0], 8.0, rtol=1e-12)


def test_a_fast_band_has_the_temperature_of_jaeger():
    n, band, speed = 4096, 64, 1e3
    width = band / M
    assert speed * 0.5 * width / (2.0 * 21.3) > 180.0  # the Péclet number
    surface = surface_of((1, n), 1e-4, diffusivity=21.3)
    flux = np.zeros((1, n))
    flux[0, :band] = 1.0
    _, rise = steady_heat(surface, np.fft.rfft2(flux), speed)
    field = np.fft.irfft2(rise, (1, n))[0]
    ahead = field[band + 2]  # the surface moves towards +x: fresh rubber enters at the last sample
    # One-dimensional conduction: 2 sqrt(D x/(pi v)) at a distance x behind the leading edge.
    whole = 2.0 * math.sqrt(21.3 * width / (math.pi * speed))
    np.testing.assert_allclose(field[:band].mean() - ahead, 2.0 / 3.0 * whole, rtol=0.015)
    np.testing.assert_allclose(field[:band].max() - ahead, whole, rtol=0.03)
