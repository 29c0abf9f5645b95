"""Properties of all laws: dispatch on types, and decay to zero without subnormal numbers."""

import ast
import shutil
from typing import NamedTuple

import numpy as np
import pytest

from elastomer_friction.kernels import (
    ConstantForce,
    Kelvin,
    PrintedForce,
    State,
    march,
    steady_sliding,
)
from elastomer_friction.kernels.compile.cache import CACHE_FOLDER
from elastomer_friction.kernels.model import steady
from elastomer_friction.kernels.rheology.law import free_displacement
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed
from tests.support.sweeps import sweep


class Squared(NamedTuple):
    """A law in a new file, which no file of kernels imports."""

    root: float  # square root of the decay
    stiffness: float
    lag: float


@free_displacement.register(Squared)
def _reach(law, u):
    return law.root * (law.root * u)


def slide(marches):
    """Return (results for each law and control, number of compilations)."""
    kelvin, squared = Kelvin(0.25, 4.0 / 3.0, 0.5), Squared(0.5, 4.0 / 3.0, 0.5)
    pairs = (kelvin, PrintedForce), (kelvin, ConstantForce), (squared, ConstantForce)
    z, numbers = np.array([3.0, 1.0, 0.0, 2.0]), []
    for k, (law, control) in enumerate(pairs):
        (w, d), _ = steady_sliding(law, z, 4.0)
        actual = [*w, d]
        if k < marches:
            start = State(0.5 * w, d)  # not steady, so that the march changes it
            mu, depth, *_ = march(law, control(4.0), z, z - 1.5, start, np.array([2]), 4.0)
            actual += [*mu, *depth]
        numbers.append([float(number) for number in actual])
    return numbers, sum(sum(one.stats.cache_misses.values()) for one in (steady_sliding, march))


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
@sweep("marches", 0, 3)  # compiling a march takes long, especially for the new law
def test_a_second_process_compiles_nothing_whatever_the_law_and_the_control(tmp_path, marches):
    """This includes the law in a new file, whose numbers are those of the Kelvin element."""
    cache = tmp_path / "cache"
    shutil.copytree(CACHE_FOLDER, cache, ignore=shutil.ignore_patterns("*.tmp*"))
    code = f"from tests.kernels.rheology import test_law; print(test_law.slide({marches}))"
    (numbers, misses), second = (
        ast.literal_eval(printed("-c", code, NUMBA_CACHE_DIR=str(cache))) for _ in range(2)
    )
    assert misses >= max(1, marches - 1)  # at least for the new law
    assert second == (numbers, 0)
    as_printed, kelvin, squared = numbers
    assert (as_printed != kelvin) == (marches > 0)  # the control matters only in marches
    assert squared == kelvin[: len(squared)]


def test_decay_never_leaves_subnormal_numbers():
    """If decay > 1/2, the smallest subnormal number times decay rounds to itself forever."""
    products = []

    class Watched(float):
        def __mul__(self, other):
            products.append(abs(float(self) * other))
            return float(self) * other

    z = np.full(3000, 5.0)
    z[2998] = 0.0  # one element touches, all others decay for almost the whole period
    law, w = Kelvin(Watched(0.7), 1.0, 0.0), np.empty_like(z)
    assert getattr(steady.sweep, "py_func", steady.sweep)(law, z, 1.0, 2998, w) == (1.0, 1.0, 1)
    assert len(products) > 2000
    assert min(p for p in products if p > 0.0) > 1e-300
