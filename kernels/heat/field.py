"""Temperature of the surface of a half-space that sliding friction heats, in Fourier space.

A flux Q(q, t) of heat into the surface raises its temperature by

    T(q, t) = (1/e) int Q(q, s) exp(-D q^2 (t - s)) / sqrt(pi (t - s)) ds,    e = sqrt(k rho c),

at points of the body. In the frame of a surface that slides over it at the velocity v, D q^2
becomes lambda = D q^2 - i q_x v, and a constant flux leads to Q/(k sqrt(lambda/D)).
Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd ed. (Oxford, 1959), ch. 10.

The square root is a sum of exponentials, from equal steps of ln y in

    1/sqrt(pi t) = (1/pi) int_0^inf exp(-y t) y^(-1/2) dy.

Each mode has a variable with the rate lambda + y for every y of the ladder above SLOW_SHARE D q^2,
and one for all below. Under a flux that is constant in a step, variables are exact. Those above the
ladder follow the flux at once: their sum is the rest of the steady value, which is exact.

The mean of the flux heats a block of thickness b whose far side is held at the temperature of the
scene: a sum over the modes of the slab, with the rates D ((n + 1/2) pi/b)^2. Without a block it
has no steady value on a half-space and is left out.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..rheology.law import MIN_MAGNITUDE

LOG_STEP = 1.0  # between rates of the ladder; rises of modes are then right to 1e-4 after one step
SLOW_SHARE = 0.04  # of D q^2; the lower rates of a mode are one variable
FAST_RATE = 10.0  # in the shortest step, of the highest rate of the ladder
MAX_SLAB_MODES = 10_000
ENDLESS_TAUS = 1e200  # a step in which every variable becomes steady; finite, for the mean mode


class HeatedSurface(NamedTuple):
    """Constants of the temperature field of a map; rates in 1/tau.

    Every row of modes has variables of all its columns below the ladder, then, for each rate of
    the ladder, those of its first columns.
    """

    q_y: np.ndarray  # wave numbers of the rows, in 1/dx, shape (rows,)
    q_x: np.ndarray  # wave numbers of the columns, in 1/dx, shape (columns,)
    diffusivity: float  # D, in dx^2/tau
    rates: np.ndarray  # y of the ladder, shape (J,)
    weights: np.ndarray  # of the variables in the root, shape (J,)
    below: tuple[float, float]  # mean rate and weight of all lower y, over those of y
    widths: np.ndarray  # number of columns of a row with a rate, shape (rows, J)
    block: float  # thickness b, in dx; 0: no mean heating
    slab_rates: np.ndarray  # shape (slab modes,), empty without a block


class HeatContent(NamedTuple):
    """Variables of a temperature field, over a flux; in the frame of the sliding surface."""

    modes: np.ndarray  # real and imaginary parts, shape (2, variables)
    slab: np.ndarray  # shape (slab modes,)


def heated_surface(
    q_y: np.ndarray, q_x: np.ndarray, diffusivity: float, block: float, min_step: float
) -> HeatedSurface:
    """Return the constants of a field; min_step : shortest step that it resolves, in tau.

    q_y, q_x : wave numbers of a real transform, of any shape, in 1/dx. block : in dx, or 0.
    """
    q_y, q_x = q_y.ravel(), q_x.ravel()
    decay = diffusivity * np.add.outer(q_y**2, q_x**2)
    lowest = SLOW_SHARE * float(decay.ravel()[1:].min())
    count = max(1, math.ceil(math.log(FAST_RATE / min_step / lowest) / LOG_STEP))
    y = lowest * np.exp(LOG_STEP * np.arange(count))
    # Sums of y^(1/2) and y^(3/2) over all lower rates, relative to those of y.
    weight, moment = (1.0 / math.expm1(power * LOG_STEP) for power in (0.5, 1.5))
    first = np.minimum(np.searchsorted(y, SLOW_SHARE * decay), count - 1)
    widths = (first[:, None] <= np.arange(count)[None, :, None]).sum(axis=2)
    slab: np.ndarray = np.empty(0)
    if block > 0.0:
        modes = block / math.pi * math.sqrt(FAST_RATE / (diffusivity * min_step))
        n = np.arange(min(MAX_SLAB_MODES, math.ceil(modes)))
        slab = diffusivity * ((n + 0.5) * math.pi / block) ** 2
    below, weights = (moment / weight, weight), LOG_STEP / math.pi * np.sqrt(y)
    return HeatedSurface(q_y, q_x, diffusivity, y, weights, below, widths, block, slab)


def cold_content(surface: HeatedSurface) -> HeatContent:
    """Return the variables of a surface at the temperature of the scene."""
    variables = int(surface.widths.sum() + surface.widths[:, -1].sum())
    return HeatContent(np.zeros((2, variables)), np.zeros(surface.slab_rates.size))


def heat(
    surface: HeatedSurface, content: HeatContent, flux: np.ndarray, moved: float, dt: float
) -> tuple[HeatContent, np.ndarray]:
    """Return the variables after a step, and the modes of the rise of the temperature.

    flux : modes of a real transform, constant in the step, in the frame of the surface, which moves
    by ``moved`` (dx) in the time dt (tau). The rise is in units of flux times dx over k.
    """
    return _heat(surface, content, flux, moved / dt, moved, dt)


def steady_heat(
    surface: HeatedSurface, flux: np.ndarray, speed: float
) -> tuple[HeatContent, np.ndarray]:
    """Return the variables and the rise under a constant flux, as ``heat`` does.

    speed : of the surface, signed, in dx/tau.
    """
    return _heat(surface, cold_content(surface), flux, speed, 0.0, ENDLESS_TAUS)


def _heat(
    surface: HeatedSurface,
    content: HeatContent,
    flux: np.ndarray,
    speed: float,
    moved: float,
    dt: float,
) -> tuple[HeatContent, np.ndarray]:
    new, rise = HeatContent(*map(np.empty_like, content)), np.empty_like(flux)
    _heat_modes(surface, content.modes, flux, speed, moved, dt, new.modes, rise)
    rise[0, 0] = _heat_slab(surface, content.slab, flux[0, 0].real, dt, new.slab)
    return new, rise


# Rows of the workspace of columns: D q^2, q_x v, factor of a step, flux, sums of variables, and of
# their steady values under a unit flux. Each but the first two is a real and an imaginary part.
DECAY, TURN, FADE, FLUX, SUM, GAIN = 0, 1, 2, 4, 6, 8


@kernel
def _heat_modes(surface, old, flux, speed, moved, dt, new, rise):
    """Fill new and rise for all modes but the mean."""
    rates, weights, (below_rate, below_weight) = surface.rates, surface.weights, surface.below
    root_d, work, at = math.sqrt(surface.diffusivity), np.empty((10, surface.q_x.size)), 0
    fades, below_fades = np.exp(-rates * dt), np.exp(-below_rate * rates * dt)
    turns = np.exp(-surface.diffusivity * surface.q_x**2 * dt) * np.exp(1j * surface.q_x * moved)
    for row in range(surface.q_y.size):
        _fill_columns(surface, surface.q_y[row], flux[row], speed, dt, turns, work)
        begin = 0
        for j in range(rates.size):
            y, weight, end = rates[j], weights[j], surface.widths[row, j]
            for first in range(2):  # the lowest variable of new columns, then that of the rate
                if first == 0:
                    columns = slice(begin, end)
                    factors = below_rate * y, below_weight * weight, below_fades[j]
                else:
                    columns, factors = slice(0, end), (y, weight, fades[j])
                size = columns.stop - columns.start
                some = slice(at, at + size)
                parts = old[0, some], old[1, some], new[0, some], new[1, some]
                _advance(work[:, columns], *parts, *factors)
                at += size
            begin = end
        _add_rest(work)
        for i in range(surface.q_x.size):
            rise[row, i] = complex(root_d * work[SUM, i], root_d * work[SUM + 1, i])


@inlined_kernel
def _fill_columns(surface, q_y, flux, speed, dt, turns, work):
    """Fill the workspace of a row of modes; turns : factors of a step without q_y."""
    fade = math.exp(-surface.diffusivity * q_y**2 * dt)
    for i in range(surface.q_x.size):
        work[DECAY, i] = surface.diffusivity * (q_y**2 + surface.q_x[i] ** 2)
        work[TURN, i] = surface.q_x[i] * speed
        work[FADE, i], work[FADE + 1, i] = fade * turns[i].real, fade * turns[i].imag
        work[FLUX, i], work[FLUX + 1, i] = flux[i].real, flux[i].imag
        work[SUM, i] = work[SUM + 1, i] = work[GAIN, i] = work[GAIN + 1, i] = 0.0


@inlined_kernel
def _advance(work, old_re, old_im, new_re, new_im, rate, weight, fade):
    """Advance variables of consecutive columns by a step, and add them to the sums.

    A variable of the rate lambda = a - i w becomes E y + Q (1 - E)/lambda, E = exp(-lambda dt).
    """
    for i in range(old_re.size):
        a, w = work[DECAY, i] + rate, work[TURN, i]
        inverse = 1.0 / (a * a + w * w)
        re, im = a * inverse, w * inverse
        e_re, e_im = work[FADE, i] * fade, work[FADE + 1, i] * fade
        g_re, g_im = (1.0 - e_re) * re + e_im * im, (1.0 - e_re) * im - e_im * re
        q_re, q_im = work[FLUX, i], work[FLUX + 1, i]
        y_re, y_im = old_re[i], old_im[i]
        new_re[i] = e_re * y_re - e_im * y_im + g_re * q_re - g_im * q_im
        new_im[i] = e_re * y_im + e_im * y_re + g_re * q_im + g_im * q_re
        work[SUM, i] += weight * new_re[i]
        work[SUM + 1, i] += weight * new_im[i]
        work[GAIN, i] += weight * re
        work[GAIN + 1, i] += weight * im


@inlined_kernel
def _add_rest(work):
    """Add what follows the flux at once, so that the steady value is Q/sqrt(D q^2 - i q_x v)."""
    for i in range(work.shape[1]):
        decay, turn = work[DECAY, i], work[TURN, i]
        size = max(math.sqrt(decay * decay + turn * turn), MIN_MAGNITUDE)  # zero for the mean
        root = math.sqrt(0.5 * (size + decay))
        re, im = root / size - work[GAIN, i], 0.5 * turn / (root * size) - work[GAIN + 1, i]
        work[SUM, i] += re * work[FLUX, i] - im * work[FLUX + 1, i]
        work[SUM + 1, i] += re * work[FLUX + 1, i] + im * work[FLUX, i]


@kernel
def _heat_slab(surface, old, flux, dt, new):
    """Fill new and return the mean temperature."""
    if surface.block == 0.0:
        return 0.0
    total, rest = 0.0, 0.5 * surface.block**2 / surface.diffusivity
    for n in range(surface.slab_rates.size):
        rate = surface.slab_rates[n]
        left = math.exp(-rate * dt)
        new[n] = left * old[n] + flux * (1.0 - left) / rate
        total += new[n]
        rest -= 1.0 / rate
    return 2.0 * surface.diffusivity / surface.block * (total + rest * flux)
