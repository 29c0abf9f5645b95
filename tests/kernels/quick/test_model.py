"""The fast computation against the reference, model/realization.py, in hard regimes."""

import math
from functools import partial

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    Case,
    Line,
    Quantities,
    quadrature,
    run_cases,
    steady_sliding,
)
from elastomer_friction.kernels.body.patch_width import samples_per_contact
from elastomer_friction.kernels.model.limits import LOAD_LIMITS, SPEED_LIMITS, check_range
from elastomer_friction.kernels.model.realization import realization
from tests.lines import random_line
from tests.sizes import size

# (Hurst exponent, elements, samples per spacing): contacts are narrower or wider than a span. Lines
# are shorter than a span, of whole spans, or with a rest; the plain march takes the shortest.
LINES = [(0.0, 5, 1), (0.0, 64, 1), (0.3, 77, 2), (0.7, 100, 4), (1.0, 48, 8)]
LINES += size([(0.0, 256, 1), (0.7, 256, 4), (1.0, 256, 2)], [])
LOADS_TESTED = (1e-6, 1e-3, 0.03, 0.3, 2.0, 40.0, 1e3)  # Fbar, from one sample to full contact
KEPT = np.unique(np.geomspace(1, size(400, 20), 12).astype(int))
RATIOS = (1.2, 0.5, 5.0)
TOLERANCE, ROUNDING = 1e-11, 1e-15


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("x", size([1e-3, 0.01, 0.3, 3.0, 30.0, 1000.0], [0.01, 3.0, 300.0]))
@pytest.mark.parametrize("point", LINES, ids=str)
def test_the_fast_path_equals_the_model(point, x, scheme):
    hurst, elements, m = point
    line = Line.from_samples(*random_line(elements, hurst, m, 3), m, band_limited=True)
    speed, ratios = x / np.pi, RATIOS[: size(3, 1)]
    kept = (KEPT,) * len(ratios)
    stepped = scheme == "implicit-euler"
    cases = [
        Case(load, speed, ratios, kept, scheme, refine=False, stepped=stepped)
        for load in LOADS_TESTED
    ]
    for case, quick in zip(cases, run_cases(line, cases, Quantities()), strict=True):
        total = case.load * line.z.size
        (w, d), _ = steady_sliding(SCHEMES[scheme](1.0 / (m * speed)), line.z, total)
        share = quadrature(line.z, line.slope, w, d, speed, speed, total)[2]
        assert quick.contact_fraction == pytest.approx(share, rel=1e-9)
        assert quick.samples_per_contact == samples_per_contact(d - (line.z - w))
        for k, ratio in enumerate(ratios):
            model = realization(line, case.load, speed, ratio, scheme, KEPT, stepped)
            largest = max(abs(model.mu_1), abs(model.mu_2), abs(model.mu_1 + model.jump))
            # mu is a mean of slopes: if these cancel, their rounding remains.
            error = TOLERANCE * largest + ROUNDING * np.abs(line.slope).max()
            near = partial(pytest.approx, rel=0.0, abs=error)
            assert quick.mu_1 == near(model.mu_1)
            assert quick.mu_2[k] == near(model.mu_2)
            assert quick.jump[k] == near(model.jump)
            assert quick.curves[k] == near(model.mu)
            deep = model.indentation + line.datum
            assert quick.indentation == pytest.approx(deep, rel=TOLERANCE, abs=TOLERANCE)


@pytest.mark.parametrize("limits", [LOAD_LIMITS, SPEED_LIMITS])
def test_both_limits_are_accepted(limits):
    for value in limits:
        check_range("speed", value, limits)


@pytest.mark.parametrize("value", [0.0, -1.0, 1e-13, 1e13, math.inf, math.nan])
def test_values_outside_the_limits_are_refused(value):
    with pytest.raises(ValueError, match=r"^speed = \S+: must lie between 1e-12 and 1e\+12$"):
        check_range("speed", value, SPEED_LIMITS)
