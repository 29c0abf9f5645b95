"""Clusters for the tests; all of these are marked ``cluster``."""

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tests.cluster.processes import Standing, Trial, end
from tests.cluster.slurm import Slurm, missing


@pytest.fixture(scope="module")
def standing(tmp_path_factory) -> Iterator[Standing]:
    """Return a scheduler and two workers, started as a user would."""
    cluster = Standing(tmp_path_factory.mktemp("standing"))
    try:
        cluster.complete()
        yield cluster
    finally:
        cluster.stop()


@pytest.fixture(scope="session")
def undisturbed(tmp_path_factory) -> bytes:
    """Return the bytes of the result of a trial of which nothing is disturbed."""
    return Trial(tmp_path_factory.mktemp("peace")).whole()


@pytest.fixture
def tried() -> Iterator[Callable[..., Trial]]:
    """Return what starts a trial, which is ended with the test."""
    with contextlib.ExitStack() as ends:

        def begin(*words: Any, **how: Any) -> Trial:
            trial = Trial(*words, **how)
            ends.callback(lambda: end(trial.driver))
            return trial

        yield begin


@pytest.fixture(scope="module")
def slurm(tmp_path_factory) -> Iterator[Slurm]:
    """Return a private SLURM of two nodes."""
    if why := missing():
        pytest.skip(f"no SLURM: {why}")
    private = Slurm(tmp_path_factory.mktemp("slurm"))
    yield private
    private.stop()
