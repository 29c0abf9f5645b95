"""Temperature of the surface of a half-space that sliding friction heats, in Fourier space.

A flux Q(q, t) of heat into the surface raises its temperature by

    T(q, t) = (1/e) int Q(q, s) exp(-D q^2 (t - s)) / sqrt(pi (t - s)) ds,    e = sqrt(k rho c),

at points of the body. In the frame of a surface that slides over it at the velocity v, D q^2
becomes lambda = D q^2 - i q_x v, and a constant flux leads to Q/(k sqrt(lambda/D)).
Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd ed. (Oxford, 1959), ch. 10.

The square root becomes a sum of exponentials, by equal steps of ln y in

    1/sqrt(pi t) = (1/pi) int_0^inf exp(-y t) y^(-1/2) dy.

The values of y form a ladder. Each mode has one variable of rate lambda + y for every y above
SLOW_SHARE D q^2, and one for all lower y. Under a flux that is constant in a step, variables are
exact. Their deviations from the steady values are stored. Variables above the ladder follow the
flux at once and do not deviate.

The mean of the flux heats a block of thickness b whose far side is held at the temperature of the
scene: a sum over the modes of the slab, with the rates D ((n + 1/2) pi/b)^2. Without a block, the
mean rise has no steady value and is left out.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..rheology.law import MIN_MAGNITUDE

LOG_STEP = 1.0  # between rates of the ladder; the error of a mode is 1e-4 after one step
SLOW_SHARE = 0.04  # of D q^2; all lower rates of a mode share one variable
FAST_RATE = 10.0  # highest rate of the ladder times the shortest step
MAX_SLAB_MODES = 10_000


class HeatedSurface(NamedTuple):
    """Constants of the temperature field of a map; rates in 1/tau.

    For each rate, a row of modes stores one variable of all lower rates for the columns whose
    ladder begins there, then one of this rate for its first ``widths`` columns.
    """

    q_y: np.ndarray  # wave numbers of the rows, in 1/dx, shape (rows,)
    q_x: np.ndarray  # wave numbers of the columns, in 1/dx, shape (columns,)
    diffusivity: float  # D, in dx^2/tau
    rates: np.ndarray  # y of the ladder, shape (J,)
    weights: np.ndarray  # of the variables, shape (J,)
    below: tuple[float, float]  # mean rate and weight of all lower y, relative to y
    widths: np.ndarray  # number of columns of a row with a rate, shape (rows, J)
    block: float  # thickness b, in dx; 0: no mean heating
    slab_rates: np.ndarray  # shape (slab modes,), empty without a block


class HeatContent(NamedTuple):
    """State of a temperature field in the frame of the sliding surface, in units of the flux."""

    flux: np.ndarray  # modes of the flux in the last step
    speed: float  # of the surface in the last step, in dx/tau
    modes: np.ndarray  # deviations of the variables, real and imaginary parts, (2, variables)
    slab: np.ndarray  # deviations of the modes of the slab, shape (slab modes,)


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
    """Return the state of a surface at the temperature of the scene."""
    variables = int(surface.widths.sum() + surface.widths[:, -1].sum())
    flux = np.zeros((surface.q_y.size, surface.q_x.size), complex)
    return HeatContent(flux, 0.0, np.zeros((2, variables)), np.zeros(surface.slab_rates.size))


def steady_heat(
    surface: HeatedSurface, flux: np.ndarray, speed: float
) -> tuple[HeatContent, np.ndarray]:
    """Return the state under a constant flux, and the modes of the rise of the temperature.

    flux : modes of a real transform, in the frame of the surface, which slides at a signed speed
    (dx/tau). The rise is in units of flux times dx over k.
    """
    rise = np.empty_like(flux)
    _fill_steady_rise(surface, flux, speed, rise)
    return cold_content(surface)._replace(flux=flux, speed=speed), rise


def heat(
    surface: HeatedSurface, content: HeatContent, flux: np.ndarray, moved: float, dt: float
) -> tuple[HeatContent, np.ndarray]:
    """Return the state after a step, and the rise as in ``steady_heat``.

    flux : constant in the step, in which the surface moves by ``moved`` (dx) in the time dt (tau).
    """
    modes, slab, rise = *map(np.empty_like, content[2:]), np.empty_like(flux)
    _fill_steady_rise(surface, flux, moved / dt, rise)
    _add_modes(surface, content, flux, moved, dt, modes, rise)
    change = (content.flux[0, 0] - flux[0, 0]).real
    rise[0, 0] += _advance_slab(surface, content.slab, change, dt, slab)
    return HeatContent(flux, moved / dt, modes, slab), rise


@kernel
def _fill_steady_rise(surface, flux, speed, rise):
    """Fill rise with the steady Q/sqrt(lambda/D), and the mean with that of the block."""
    for row in range(rise.shape[0]):
        for column in range(rise.shape[1]):
            q_x = surface.q_x[column]
            square = surface.q_y[row] ** 2 + q_x**2
            turn = q_x * speed / surface.diffusivity
            size = max(math.sqrt(square * square + turn * turn), MIN_MAGNITUDE)  # zero for the mean
            root = math.sqrt(0.5 * (size + square))
            re, im = root / size, 0.5 * turn / (root * size)
            q = flux[row, column]
            rise[row, column] = complex(re * q.real - im * q.imag, re * q.imag + im * q.real)
    rise[0, 0] = surface.block * flux[0, 0]


# Rows of the workspace of columns: D q^2, q_x v before and in the step, factor of the step, flux
# before and in it, and sum of deviations. The last four are real and imaginary parts.
DECAY, OLD_TURN, TURN, FADE, OLD_FLUX, FLUX, SUM = 0, 1, 2, 3, 5, 7, 9


@kernel
def _add_modes(surface, content, flux, moved, dt, new, rise):
    """Fill new, and add the deviations to the rise of all modes but the mean."""
    rates, weights, (below_rate, below_weight) = surface.rates, surface.weights, surface.below
    root_d, work, at = math.sqrt(surface.diffusivity), np.empty((11, surface.q_x.size)), 0
    old = content.modes
    fades, below_fades = np.exp(-rates * dt), np.exp(-below_rate * rates * dt)
    turns = np.exp(-surface.diffusivity * surface.q_x**2 * dt) * np.exp(1j * surface.q_x * moved)
    for row in range(surface.q_y.size):
        _fill_columns(surface, surface.q_y[row], dt, turns, work)
        _fill_fluxes(surface, content.speed, content.flux[row], OLD_TURN, OLD_FLUX, work)
        _fill_fluxes(surface, moved / dt, flux[row], TURN, FLUX, work)
        begin = 0
        for j in range(rates.size):
            y, weight, end = rates[j], weights[j], surface.widths[row, j]
            for first in range(2):  # lower rates of new columns, then this rate
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
        for i in range(surface.q_x.size):
            if row > 0 or i > 0:
                rise[row, i] += complex(root_d * work[SUM, i], root_d * work[SUM + 1, i])


@inlined_kernel
def _fill_columns(surface, q_y, dt, turns, work):
    """Fill the workspace of a row of modes; turns : factors of a step without q_y."""
    fade = math.exp(-surface.diffusivity * q_y**2 * dt)
    for i in range(surface.q_x.size):
        work[DECAY, i] = surface.diffusivity * (q_y**2 + surface.q_x[i] ** 2)
        work[FADE, i], work[FADE + 1, i] = fade * turns[i].real, fade * turns[i].imag
        work[SUM, i] = work[SUM + 1, i] = 0.0


@inlined_kernel
def _fill_fluxes(surface, speed, flux, turn, row, work):
    """Fill the rows of the workspace for a speed and its flux."""
    for i in range(surface.q_x.size):
        work[turn, i] = surface.q_x[i] * speed
        work[row, i], work[row + 1, i] = flux[i].real, flux[i].imag


@inlined_kernel
def _advance(work, old_re, old_im, new_re, new_im, rate, weight, fade):
    """Advance the deviations of consecutive columns by a step, and add them to the sums.

    A variable y of the rate lambda = a - i w and the weight W becomes E y + Q (1 - E)/lambda, with
    E = exp(-lambda dt). Its deviation W (y - Q/lambda) is multiplied by E after Q and lambda have
    changed.
    """
    for i in range(old_re.size):
        a, w_old, w = work[DECAY, i] + rate, work[OLD_TURN, i], work[TURN, i]
        old_scale, scale = weight / (a * a + w_old * w_old), weight / (a * a + w * w)
        e_re, e_im = work[FADE, i] * fade, work[FADE + 1, i] * fade
        p_re, p_im = old_scale * work[OLD_FLUX, i], old_scale * work[OLD_FLUX + 1, i]
        q_re, q_im = scale * work[FLUX, i], scale * work[FLUX + 1, i]
        u_re = old_re[i] + (p_re * a - p_im * w_old) - (q_re * a - q_im * w)
        u_im = old_im[i] + (p_re * w_old + p_im * a) - (q_re * w + q_im * a)
        new_re[i] = e_re * u_re - e_im * u_im
        new_im[i] = e_re * u_im + e_im * u_re
        work[SUM, i] += new_re[i]
        work[SUM + 1, i] += new_im[i]


@kernel
def _advance_slab(surface, old, change, dt, new):
    """Fill new, and return the deviation of the mean temperature from its steady value."""
    total = 0.0
    for n in range(surface.slab_rates.size):
        rate = surface.slab_rates[n]
        new[n] = math.exp(-rate * dt) * (old[n] + change / rate)
        total += new[n]
    return 2.0 * surface.diffusivity / surface.block * total if surface.block > 0.0 else 0.0
