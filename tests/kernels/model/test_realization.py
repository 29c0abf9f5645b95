"""The model in one function is the reference: the quick path gives its numbers in hard corners."""

import math
from functools import partial

import numba
import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Case, Line, Quantities, amplitudes, run_case
from elastomer_friction.kernels.model.limits import LOADS, SPEEDS, check_between
from elastomer_friction.kernels.model.realization import realization

ELEMENTS = 40 if numba.config.DISABLE_JIT else 256
KEPT = np.unique(np.geomspace(1, 40 if numba.config.DISABLE_JIT else 400, 12).astype(int))
CLOSE, ROUNDING = 1e-11, 1e-15
PRESSED = {"a point": 1e-6, "light": 1e-3, "middle": 0.1, "heavy": 3.0, "full contact": 1e3}


def line_of(hurst, steps):
    """Return a random line."""
    phases = np.random.default_rng(7).uniform(0.0, 2.0 * np.pi, ELEMENTS // 2)
    return Line.self_affine(amplitudes(hurst, ELEMENTS), phases, ELEMENTS, steps)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", PRESSED)
@pytest.mark.parametrize("x", [0.01, 0.3, 3.0, 30.0, 1000.0])
def test_the_quick_path_gives_the_numbers_of_the_model(scheme, load, x):
    asked, speed = Quantities(), x / np.pi
    for hurst, steps, ratio in ((0.0, 1, 1.2), (0.7, 4, 0.5), (1.0, 2, 5.0)):
        line = line_of(hurst, steps)
        case = Case(PRESSED[load], speed, (ratio,), (KEPT,), scheme, refine=False)
        quick = run_case(line, case, asked)
        model = realization(line, PRESSED[load], speed, ratio, scheme, KEPT)
        size = max(abs(model.mu_1), abs(model.mu_2), abs(model.mu_1 + model.jump))
        # mu is a mean of slopes: where they cancel, their rounding is left.
        near = partial(
            pytest.approx, rel=0.0, abs=CLOSE * size + ROUNDING * np.abs(line.slope).max()
        )
        assert quick.mu_1 == near(model.mu_1)
        assert quick.mu_2[0] == near(model.mu_2)
        assert quick.jump[0] == near(model.jump)
        assert quick.curves[0] == near(model.mu)
        deep = model.indentation + line.datum
        assert quick.indentation == pytest.approx(deep, rel=CLOSE, abs=CLOSE)


@pytest.mark.parametrize("limits", [LOADS, SPEEDS])
def test_both_limits_are_taken(limits):
    for value in limits:
        check_between("speed", value, limits)


@pytest.mark.parametrize("value", [0.0, -1.0, 1e-13, 1e13, math.inf, math.nan])
def test_what_lies_outside_is_named_with_what_would_be_right(value):
    with pytest.raises(ValueError, match=r"^speed = \S+: must lie between 1e-12 and 1e\+12$"):
        check_between("speed", value, SPEEDS)
