"""Lines or maps of a batch: drawn at random, or measured."""

from collections.abc import Callable, Iterable
from itertools import islice

import numpy as np

from ...kernels import QUARTET, Line, amplitudes, draw_phases
from ...kernels.half_space.surface import Surface, ring_amplitudes
from .tasks import Batch

# One drawing: steps per spacing -> its lines or maps, of consecutive realizations.
Draw = Callable[[int], Iterable]


def drawn_lines(batch: Batch) -> tuple[int, Callable[[int], Draw]]:
    """Return the realizations per drawing, and a function: first realization -> drawing.

    Self-affine lines are drawn in quartets within a block. Measured lines, and random lines with
    their spectrum, are drawn one by one.
    """
    if batch.heights is not None:
        heights = batch.heights
        return 1, lambda number: lambda steps: (Line.measured(heights[number], steps),)
    problem = batch.tasks[0].problem  # all tasks have the same lines
    hurst, elements, surface = problem.hurst, problem.elements, problem.surface
    size = 1 if surface.measured else min(QUARTET, batch.realizations_per_block)
    amplitude = batch.modes
    if amplitude is None:
        modes = surface.rolloff, surface.cutoff
        amplitude = amplitudes(hurst, elements, batch.normalisation, *modes)
    first = batch.first_block * batch.realizations_per_block

    def draw(number: int) -> Draw:
        generator = line_generator(batch.seed, hurst, elements, (first + number) // size)
        phases = draw_phases(generator, elements)
        return lambda steps: islice(Line.quartet(amplitude, phases, elements, steps), size)

    return size, draw


def drawn_maps(batch: Batch) -> tuple[int, Callable[[int], Draw]]:
    """Return one realization per drawing, and a function: realization -> drawing of its map."""
    if batch.heights is not None:
        heights = batch.heights
        return 1, lambda number: lambda steps: (Surface.measured(heights[number], steps),)
    problem = batch.tasks[0].problem
    hurst, elements, surface = problem.hurst, problem.elements, problem.surface
    amplitude = batch.modes
    if amplitude is None:
        modes = surface.rolloff, surface.cutoff
        amplitude = ring_amplitudes(hurst, elements, *modes, batch.normalisation)
    first = batch.first_block * batch.realizations_per_block

    def draw(number: int) -> Draw:
        def drawn(steps: int) -> Iterable[Surface]:
            generator = line_generator(batch.seed, hurst, elements, first + number)
            return (Surface.drawn(generator, amplitude, elements, steps),)

        return drawn

    return 1, draw


def line_generator(seed: int, hurst: float, elements: int, index: int) -> np.random.Generator:
    """Return the random generator of one drawing, given by study seed, H, N and index alone.

    The lines are therefore the same for every m, scheme, load and speed, in any batch and order.
    """
    hurst_bits = int(np.float64(hurst).view(np.uint64))
    return np.random.default_rng([seed, hurst_bits, elements, index])
