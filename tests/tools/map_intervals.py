"""Second part of `make intervals`: standard errors of single maps, in a minute.

Each of 20 ensembles has maps of one spectrum, with a longest wave of a quarter of the side. The
difference between a map and the mean of the others must be within one error in 60 to 76 % of maps,
on average over the ensembles. As on measured maps, amplitudes of modes are random. With
`--random-phase` they are fixed: friction in full contact is then the same on all maps.
"""

import sys
from itertools import product

import numpy as np

from elastomer_friction.kernels import KELVIN, Quantities, Spectrum
from elastomer_friction.kernels.half_space.surface import (
    Surface,
    ring_amplitudes,
    rms_slope_of,
)
from elastomer_friction.workflow.reduce.blocks import Blocks, Estimates
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.simulate.layout import row_layout, unpack
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import Batch, LineShape, Problem, Recording, Task
from elastomer_friction.workflow.study.surfaces.surface import TILE_WAVES

MAPS, ELEMENTS, STEPS, WAVES, HURST = 24, 16, 4, 4, 0.7
TILES = round(WAVES / TILE_WAVES)
BRANCHES = Spectrum((2.0,) * 5, (0.01, 0.1, 1.0, 10.0, 100.0), 0.0)
LOADS, SPEED_RATIOS = (0.03, 0.2), (0.3, 1.0, 3.0, 10.0, 30.0)  # over E* grad z; x
NAMES = ("mu_1", "mu_2", "contact_fraction", "jump")
PERMITTED = 0.60, 0.76


def maps_of_random_amplitude(amplitudes: np.ndarray, seed: int) -> np.ndarray:
    """Return maps (MAPS, N, N) whose modes have Gaussian amplitudes with these rms values."""
    generator, maps = np.random.default_rng(seed), []
    for _ in range(MAPS):
        drawn = amplitudes * np.sqrt(generator.exponential(size=amplitudes.shape))
        maps.append(Surface.drawn(generator, drawn, ELEMENTS, 1).z)
    return np.array(maps)


def estimates(
    spectrum: Spectrum, load: float, ratio: float, seed: int, gaussian: bool
) -> Estimates:
    """Return the estimates of an ensemble: an entry for each map, as of a single one."""
    amplitudes = ring_amplitudes(HURST, ELEMENTS, WAVES)
    force = load * rms_slope_of(amplitudes, ELEMENTS) * ELEMENTS
    shape = LineShape(rolloff=WAVES, body="half-space")
    problem = Problem(HURST, ELEMENTS, force, ratio / np.pi, 1.2, spectrum, shape)
    settings = Quantities(relaxation=False), "exponential", Recording(64, tiles=TILES)
    task = Task(problem, STEPS, 0, "")
    heights = maps_of_random_amplitude(amplitudes, seed) if gaussian else None
    done = block_means(Batch(seed, "modal", *settings, (task,), 0, MAPS, 1, 0.0, heights=heights))
    tiles = unpack(done.curves[0][:, None], row_layout(task, *settings))
    time, slopes = np.empty((MAPS, 0)), np.ones(MAPS)
    return reduce_blocks(Blocks(done.scalars[0][:, None], tiles, time, slopes, ("steady", "jump")))


def coverage(result: Estimates, name: str) -> float:
    """Return the share of maps that differ from the mean of the others by at most one error."""
    value, error = result[name], result[f"{name}_error"]
    others = (value.sum() - value) / (MAPS - 1)
    off = np.abs(value - others) / np.sqrt(MAPS / (MAPS - 1))
    known = np.isfinite(error)
    return float(np.mean(off[known] <= error[known]))


def main() -> int:
    """Print the table; return 1 if the coverage is not as claimed."""
    gaussian = "--random-phase" not in sys.argv
    print(f"Share of {MAPS} single maps within one standard error: {', '.join(NAMES)}")
    shares = []
    points = product((KELVIN, BRANCHES), LOADS, SPEED_RATIOS)
    for seed, (spectrum, load, ratio) in enumerate(points):
        result = estimates(spectrum, load, ratio, seed, gaussian)
        names = NAMES if spectrum == KELVIN else NAMES[:-1]
        cells = [coverage(result, name) for name in names]
        shares.append(cells + [np.nan] * (len(NAMES) - len(cells)))
        material = "Kelvin" if spectrum == KELVIN else "five branches"
        words = "  ".join(f"{cell:.2f}" for cell in cells)
        print(f"  {material:14s} load {load:4g}  x {ratio:4g}   {words}", flush=True)
    mean = np.nanmean(shares, axis=0)
    print("mean: " + ", ".join(f"{n} {share:.3f}" for n, share in zip(NAMES, mean, strict=True)))
    sound = bool((mean >= PERMITTED[0]).all() and (mean <= PERMITTED[1]).all())
    print("as claimed" if sound else "not as claimed")
    return 0 if sound else 1


if __name__ == "__main__":
    sys.exit(main())
