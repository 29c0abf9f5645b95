"""`make intervals`: check the stated errors, in some minutes; exit status 1 if they are wrong.

Many small independent studies compute the same points. The intervals value +- t error, with
Student's t for the stated degrees of freedom, must contain the reference (the mean of all studies)
as often as they claim: in each cell within four binomial errors, and on average over all cells
within three errors of the mean. There are 84 cells, and those of one column share their lines.
Studies that add realizations in rounds until they meet an accuracy are tested in the same way.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from typing import NamedTuple

import numpy as np
from scipy.stats import t as student

from elastomer_friction.kernels import QUARTET, Quantities, amplitudes, rms_slope
from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.plan.goal import (
    JACKKNIFE_GROUPS,
    Goal,
    horizon_steps,
    least_blocks,
    steps_per_spacing,
)
from elastomer_friction.workflow.reduce.attainment import attained
from elastomer_friction.workflow.reduce.blocks import Blocks, Estimates
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.reduce.jackknife import grouped_means
from elastomer_friction.workflow.run.collect import next_blocks
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.recorded_steps import curve_times, record_steps
from elastomer_friction.workflow.simulate.tasks import Batch, Problem, Recording, Task
from elastomer_friction.workflow.study.numerics import Numerics
from elastomer_friction.workflow.study.study import Scene

SEED = 7
STUDIES, LINES = 160, 256  # number of independent studies; largest number of lines of each
BLOCKS = LINES // QUARTET
POINTS = {  # name: problem, accuracy that requires a few rounds
    "H=0.7 x=10": (Problem(0.7, 500, 0.05, 10.0 / np.pi, 1.2), 0.05),
    "H=0.3 x=30": (Problem(0.3, 500, 0.05, 30.0 / np.pi, 1.2), 0.05),
    "H=0.5 x=3, light": (Problem(0.5, 500, 0.005, 3.0 / np.pi, 1.2), 0.05),
    "H=0 x=3": (Problem(0.0, 500, 0.1, 3.0 / np.pi, 1.2), 0.02),
}
SIZES = (8, 16, 32, 64, 128, 256)  # lines, in quartets
NAMES = ("mu_1", "jump", "relaxation_rate")
LEVELS = np.array([0.68, 0.95])
SINGLE = 4.0  # binomial errors by which one cell may deviate
SAMPLES = 64
ALL = ("steady", "jump", "relaxation")


class Lines(NamedTuple):
    """Block means of all quartets of one point."""

    scalars: np.ndarray  # shape (studies, blocks, scalars)
    curves: np.ndarray  # shape (studies, blocks, samples - 1)
    time: np.ndarray  # shape (samples - 1,)
    slope: float  # rms slope


def compute(problem: Problem, seed: int = SEED) -> Lines:
    """Run all lines of all studies of a point."""
    steps = int(steps_per_spacing(problem, Scene(), Numerics()))
    march = int(horizon_steps(problem, Numerics(), steps))
    task = Task(problem, steps, march, "")
    count, recording = STUDIES * BLOCKS, Recording(SAMPLES)
    settings = seed, "modal", Quantities(), "exponential", recording, (task,)
    done = block_means(Batch(*settings, 0, count, QUARTET, 0.0))
    recorded = record_steps(march, SAMPLES)
    time = np.full(SAMPLES - 1, np.nan)
    steps_per_tau = problem.speed * problem.ratio * steps
    time[: recorded.size] = curve_times(recorded, steps_per_tau, "exponential")
    shape = (STUDIES, BLOCKS, -1)
    slope = rms_slope(amplitudes(problem.hurst, problem.elements), problem.elements)
    return Lines(done.scalars.reshape(shape), done.curves.reshape(shape), time, slope)


def reduced(lines: Lines, scalars: np.ndarray, curves: np.ndarray) -> Estimates:
    """Return the estimates from block means, shape (studies, blocks, ...)."""
    count = len(scalars)
    time, slopes = np.tile(lines.time, (count, 1)), np.full(count, lines.slope)
    return reduce_blocks(Blocks(scalars, {"curve": curves}, time, slopes, ALL))


def estimates(lines: Lines, studies: np.ndarray, blocks: int) -> Estimates:
    """Return the estimates of some studies from the first blocks of each."""
    groups = min(blocks, JACKKNIFE_GROUPS)
    scalars, curves = (
        np.stack([grouped_means(whole[study, :blocks], groups) for study in studies])
        for whole in (lines.scalars, lines.curves)
    )
    return reduced(lines, scalars, curves)


def reference(lines: Lines) -> Estimates:
    """Return the estimates from all lines of all studies, each study a block."""
    return reduced(lines, *(whole.mean(axis=1)[None] for whole in (lines.scalars, lines.curves)))


def stopped(lines: Lines, problem: Problem, wanted: float) -> tuple[Estimates, np.ndarray]:
    """Return estimates and numbers of blocks of studies run in rounds to an accuracy."""
    scatter = {name: float(LAWS[name].scatter(problem)) for name in NAMES}
    goal = Goal(0, dict.fromkeys(NAMES, 0.0), scatter, 0.0)
    size = np.full(STUDIES, least_blocks(NAMES))
    running = np.arange(STUDIES)
    actual: Estimates = {}
    while running.size:
        for count in np.unique(size[running]):
            some = running[size[running] == count]
            for name, values in estimates(lines, some, int(count)).items():
                actual.setdefault(name, np.empty((STUDIES, *values.shape[1:]), values.dtype))
                actual[name][some] = values
        goals, ratios = [goal] * running.size, np.full(running.size, problem.ratio)
        some = {name: values[running] for name, values in actual.items()}
        growth = attained(some, goals, ratios, wanted, QUARTET * size[running]).growth
        both = zip(size[running].tolist(), growth.tolist(), strict=True)
        before, size[running] = size[running], [next_blocks(n, g, BLOCKS) for n, g in both]
        running = running[size[running] > before]
    return actual, size


def coverage(result: Estimates, truth: Estimates, name: str) -> tuple[np.ndarray, int]:
    """Return how often intervals at LEVELS contain the reference, and the number of studies."""
    off = np.abs(result[name] - truth[name]) / result[f"{name}_error"]
    widths = student.ppf(0.5 + 0.5 * LEVELS, result["degrees_of_freedom"][:, None])
    known = ~np.isnan(off)
    if not known.any():
        return np.full(LEVELS.size, np.nan), 0
    return np.mean(off[known, None] <= widths[known], axis=0), int(known.sum())


def row(label: str, result: Estimates, truth: Estimates) -> list[np.ndarray]:
    """Print the coverage of all estimates; return their deviations in binomial errors."""
    cells, off = [], []
    for name in NAMES:
        shares, studies = coverage(result, truth, name)
        if not studies:  # with two quartets no b is significant
            cells.append(f"{'none':17s}")
            continue
        off.append((shares - LEVELS) / np.sqrt(LEVELS * (1.0 - LEVELS) / studies))
        mark = "*" if np.abs(off[-1]).max() > SINGLE else " "
        cells.append(f"{shares[0]:5.2f} {shares[1]:5.2f} {studies:4d}{mark}")
    print(f"  {label:32s}" + "   ".join(cells), flush=True)
    return off


def main() -> int:
    """Print the table; return 1 if the coverage is not as claimed."""
    off: list[np.ndarray] = []
    print(f"Share of {STUDIES} studies whose 68 % and 95 % intervals hold the reference")
    print(f"  {'realizations':32s}" + "   ".join(f"{name:17s}" for name in NAMES))
    with ProcessPoolExecutor() as pool:
        work = pool.map(compute, [problem for problem, _ in POINTS.values()])
        for (name, (problem, wanted)), lines in zip(POINTS.items(), work, strict=True):
            truth = reference(lines)
            assert truth["fit_status"][0] == FITTED
            print(f"{name}, F = {problem.load:g}")
            for size in SIZES:
                actual = estimates(lines, np.arange(STUDIES), size // QUARTET)
                off += row(f"{size} lines, {size // QUARTET} quartets", actual, truth)
            actual, sizes = stopped(lines, problem, wanted)
            label = f"rounds to {wanted:.0%}, {QUARTET * sizes.mean():.0f} lines on average"
            off += row(label, actual, truth)
    mean = np.mean(off, axis=0)
    print(f"mean of all cells: {mean[0]:+.2f}, {mean[1]:+.2f} binomial errors from the claim")
    columns = len(POINTS) * len(NAMES)  # these are independent of each other, unlike sizes
    sound = np.abs(off).max() <= SINGLE and np.abs(mean).max() <= 3.0 / np.sqrt(columns)
    print("as claimed" if sound else "not as claimed")
    return 0 if sound else 1


if __name__ == "__main__":
    sys.exit(main())
