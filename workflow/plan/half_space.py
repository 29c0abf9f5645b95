"""Settings for a half-space: steps per spacing, errors and memory, by measured laws.

The functions take a problem or a stack of problems, like the laws of the foundation
(error_laws.py, cost.py). A map has (N m)^2 samples, and eight per shortest wave at m = 4.

Errors: 15 problems at H = 0.7, N = 16, sigma_0/(E* grad z) 0.01 ... 0.2, x 0.3 ... 30, four maps
each with m = 2, 4, 8 against m = 16. The error of mu_1 was 1 to 2.4 % at m = 4 and at most 0.5 % at
m = 8, for any load and x. With many samples per contact patch the error of the jump is as small;
with n samples per patch it is up to 2/n. Other maps, and materials without a dashpot, have the
error of ``equivalent_steps``: m = 1, 2, 3, 4 against 4, 8 or 16 on spheres of 64^2 and 128^2, maps
of 64^2 with cut-offs of 4, 8 and 16 dx and 128^2 samples of asphalt, one, five and twelve branches.
Of 235 errors 207 were within the bound; of 134 others, which did not serve to choose it, 131. It
is exceeded at m = 2 and 3 on maps that are rough down to their samples: by errors of 12 % for a
bound of 11 %, in one case 7.0 % for 3.3 %, and 17 % for 4.4 % on a map of 16^2 samples.

Scatter: standard error times the root of the number of maps; 264 problems, sigma_0/(E* grad z)
0.002 ... 0.6, x 0.1 ... 30, H 0 ... 1, side of one or two longest waves, N 8 ... 64. Two in three
are within a factor of 1.6. No law describes the scatter of b.
"""

from functools import partial

import numpy as np

from ...kernels import KELVIN
from ..simulate import Problem
from ..study import HALF_SPACE, accuracy_estimates
from .error_laws import LAWS, Laws
from .problems import Numbers, line_slope, nominal_pressure, speed_ratio
from .shortest_wave import REFERENCE_WAVE_NUMBER, ROUGHEST_WAVE

LEAST_OF_MAPS = 4
STEPS_OF_MAPS = 1, 2, 3, 4, 6, 8, 12, 16  # among which "auto" chooses
MAX_MAP_SAMPLES = 4096**2  # of a map; a worker then needs 4 GiB and more
# Memory of a worker that "auto" may use: the default of cluster.memory, so that no result depends
# on the machine.
AUTO_BYTES = 2e9
WORKER_BYTES = 235e6  # interpreter, libraries, machine code
# Memory measured on maps of 512^2 and 1024^2 samples, without branches and with 13, and marches of
# 512^2 samples with heat, whose field needs 146 to 480 bytes per sample at 0.01 to 30 m/s. Steady
# sliding alone stores no branches: 303 bytes with 12 of them, 308 without.
MAP_BYTES, BRANCH_BYTES, HEAT_BYTES = 310.0, 25.0, 480.0  # per sample; the second for each branch
STEADY_QUANTITIES = {"steady", "persson", "model_ratio"}  # quantities without jump or march
# Terms of ln(scatter): constant, and coefficients of ln(contact area), ln(free area), ln(longest
# waves per side), ln(elements per longest wave), H and ln(x).
SCATTER = {
    "mu_1": (-1.09, -0.40, 0.37, -1.12, -0.87, 0.87, -0.14),
    "jump": (-0.28, -0.40, 0.43, -1.20, -1.00, 0.63, -0.02),
}
MIN_MAP_ERROR = 1e-3  # of the solution itself
LEAST_FREE = 0.1  # smallest free area at which the scatter was measured


def steps_for(problem: Problem, quantities: tuple[str, ...], wanted: float) -> Numbers:
    """Return the smallest m whose error of the requested quantities is at most ``wanted``.

    If no m reaches it within AUTO_BYTES, return the largest m that fits, or 1.
    """
    steps = np.full(np.shape(problem.load), STEPS_OF_MAPS[0])
    for finer in STEPS_OF_MAPS[1:]:
        coarse = largest_error(problem, quantities, steps) > wanted
        fits = WORKER_BYTES + map_bytes(problem, finer, quantities) <= AUTO_BYTES
        steps = np.where(coarse & fits, finer, steps)
    return steps


def largest_error(problem: Problem, quantities: tuple[str, ...], steps: Numbers) -> Numbers:
    """Return the largest predicted error of the estimates of requested quantities.

    With branches no law predicts the samples per patch; the error of mu_1 is returned.
    """
    names = accuracy_estimates(quantities) if problem.spectrum == KELVIN else ()
    return np.max([expected_error(name, problem, steps) for name in names or ("mu_1",)], axis=0)


def map_bytes(problem: Problem, steps: Numbers, quantities: tuple[str, ...]) -> Numbers:
    """Return the memory of a map with its fields. quantities : requested ones."""
    stored = 0 if STEADY_QUANTITIES.issuperset(quantities) else 1
    per_sample = MAP_BYTES + stored * BRANCH_BYTES * len(problem.spectrum.moduli)
    if problem.effects.heat:
        per_sample += HEAT_BYTES
    return per_sample * problem.samples(steps)


def map_fits_worker(problem: Problem, steps: Numbers) -> Numbers:
    """Return whether a map with these steps per spacing fits a worker, and m was tested."""
    return ((problem.elements * steps) ** 2 <= MAX_MAP_SAMPLES) & (steps <= STEPS_OF_MAPS[-1])


def equivalent_steps(problem: Problem, steps: Numbers) -> Numbers:
    """Return the m at which a map whose shortest wave w is 2 dx has the error of this map.

    The error of m steps is e(m) ((1 - s) (2/w)^2 + s), where e(m) ~ m^-2 is that of such a map. The
    share s of the loss is due to branches that relax within a step, or to the dashpot. They
    dissipate at contact edges, in waves as short as the samples, even on smooth maps.
    """
    wave = problem.surface.shortest
    share = _fast_share(problem, REFERENCE_WAVE_NUMBER * ROUGHEST_WAVE / wave, steps)
    return steps / np.sqrt((1.0 - share) * (ROUGHEST_WAVE / wave) ** 2 + share)


def _fast_share(problem: Problem, wave_number: float, steps: Numbers) -> Numbers:
    """Return the share of E'' of branches that relax within a step; wave_number : in 1/dx.

    A branch with the relaxation time t counts by 1/(1 + (t/step)^2).
    """
    moduli, times, viscosity = problem.spectrum
    speed = np.abs(problem.speed)[..., None]
    phase = wave_number * speed * np.array(times)
    loss = np.array(moduli) * phase / (1.0 + phase**2)
    fast = loss / (1.0 + (np.asarray(steps)[..., None] * speed * np.array(times)) ** 2)
    dashpot = viscosity * wave_number * speed[..., 0]
    total = np.maximum(loss.sum(axis=-1) + dashpot, np.finfo(float).tiny)
    return (fast.sum(axis=-1) + dashpot) / total


def map_error(name: str, steps: Numbers, samples: Numbers) -> Numbers:
    """Return the error of an estimate.

    steps : from ``equivalent_steps``. samples : per connected contact patch.
    """
    whole = np.maximum(0.38 / np.asarray(steps) ** 2.0, MIN_MAP_ERROR)
    if name == "mu_1":
        return whole
    patches = np.minimum(2.0 / np.maximum(samples, 1.0), 1.0)
    return np.hypot(whole if name == "jump" else 2.0 * whole, patches)


def euler_map_error(name: str, steps: Numbers) -> Numbers:
    """Return the error of an estimate by implicit Euler steps.

    It bounds 40 means of mu_1 and its jump over 4 maps: m 1 ... 8, x 0.3, 3 and 30 at
    sigma_0/(E* grad z) = 0.01, x 0.3 and 3 at 0.1.
    """
    return (2.0 if name == "mu_1" else 4.0) / np.asarray(steps)


def expected_samples(problem: Problem, steps: Numbers) -> Numbers:
    """Return the expected samples per contact patch, within a factor of two at best."""
    load = nominal_pressure(problem) / line_slope(problem)
    patch = 1500.0 * load**0.9 / (1.0 + speed_ratio(problem) / 2.5)
    return np.maximum(patch, 3.0) * np.asarray(steps) ** 2.0 / 16.0


def expected_error(name: str, problem: Problem, steps: Numbers) -> Numbers:
    """Return the predicted error of an estimate."""
    equivalent = equivalent_steps(problem, steps)
    return map_error(name, equivalent, expected_samples(problem, equivalent))


def expected_area(problem: Problem) -> Numbers:
    """Return the expected share of real contact; nine in ten measurements are 0.7 to 1.2 times it.

    For light loads and slow sliding, which does not stiffen the elastomer, it is that of Persson's
    theory, 2.26 sigma_0/(E* grad z).
    """
    load = nominal_pressure(problem) / line_slope(problem)
    stiffer = np.hypot(1.0, speed_ratio(problem) / (0.83 + 0.77 * problem.hurst))
    return np.tanh(2.26 * load / stiffer)


def expected_scatter(name: str, problem: Problem) -> Numbers:
    """Return the scatter of an estimate from map to map."""
    constant, touching, free, longest, shortest, rough, fast = SCATTER[name]
    waves, area = max(problem.surface.rolloff, 1.0), expected_area(problem)
    contacts = area**touching * np.maximum(1.0 - area, LEAST_FREE) ** free
    spectrum = waves**longest * (problem.elements / waves) ** shortest
    size = np.exp(constant + rough * problem.hurst)
    return size * contacts * spectrum * speed_ratio(problem) ** fast


LAWS_OF_MAPS = {
    name: Laws(partial(expected_error, name), partial(expected_scatter, name)) for name in SCATTER
}


def laws_of(problem: Problem) -> dict[str, Laws]:
    """Return the laws of the estimates of a problem, on either body."""
    return LAWS_OF_MAPS if problem.surface.body == HALF_SPACE else LAWS
