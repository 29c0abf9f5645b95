"""Portions: tasks that are reduced in one call, from the results of batches."""

import time
from typing import NamedTuple

import numpy as np

from ..simulate import SCALARS, BatchResult, Task
from .blocks import Estimates, Reduction, blocks_of
from .estimates import reduce_blocks
from .jackknife import grouped_means


class BlockPlace(NamedTuple):
    """Consecutive blocks of a task of a portion that a batch computes."""

    row: int  # task in the portion
    task: int  # task in the batch
    first: int  # block of the task
    blocks: int


class StoredBlocks(NamedTuple):
    """Block means of a task of a portion that were stored before."""

    row: int  # task in the portion
    blocks: np.ndarray  # numbers of the blocks
    scalars: np.ndarray  # shape (blocks, len(SCALARS))
    curves: np.ndarray  # shape (blocks, width)


class Portion(NamedTuple):
    """Tasks with equal numbers of jackknife groups, and the places of their block means."""

    how: Reduction
    tasks: list[Task]
    blocks: list[int]  # of each task
    groups: int  # of the jackknife
    width: int  # of a row of the store
    places: list[list[BlockPlace]]  # in each result
    stored: list[StoredBlocks]


def reduce_portion(portion: Portion, *results: BatchResult) -> tuple[Estimates, float]:
    """Return the estimates of a portion and the CPU time (s). results : as ``portion.places``."""
    began = time.thread_time()
    scalars = [np.empty((count, len(SCALARS))) for count in portion.blocks]
    curves = [np.full((count, portion.width), np.nan) for count in portion.blocks]
    for place, result in (
        (place, result)
        for places, result in zip(portion.places, results, strict=True)
        for place in places
    ):
        blocks = slice(place.first, place.first + place.blocks)
        row = result.curves[place.task, : place.blocks, : portion.width]
        scalars[place.row][blocks] = result.scalars[place.task, : place.blocks]
        curves[place.row][blocks, : row.shape[1]] = row
    for stored in portion.stored:
        scalars[stored.row][stored.blocks] = stored.scalars
        curves[stored.row][stored.blocks] = stored.curves
    means = (
        np.stack([grouped_means(task, portion.groups) for task in tasks])
        for tasks in (scalars, curves)
    )
    estimates = reduce_blocks(blocks_of(portion.how, portion.tasks, *means))
    return estimates, time.thread_time() - began
