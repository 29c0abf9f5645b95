"""The indentation under a load, found by spans: equal to the plain solver, in few sweeps."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, Line, steady_sliding
from elastomer_friction.kernels.quick.steady.span_sliding import (
    APPROACH_STEPS,
    LOAD_TOLERANCE,
    approach_indentation,
    decay_factors,
    span_indentation,
)
from elastomer_friction.kernels.quick.steady.spans import (
    SPAN,
    spans_of_line,
    stack_of,
    thresholds_of,
)
from tests.lines import random_line
from tests.sizes import size

LINES = [(0.0, 5, 1, 3.0), (0.3, 77, 2, 0.05), (0.7, 100, 4, 2.0), (1.0, 48, 8, 500.0)]
LOADS = (1e-6, 1e-3, 0.03, 0.3, 2.0, 40.0)  # Fbar, from a sample to full contact


def line_at(point):
    """Return the random line of a point."""
    hurst, elements, m, _ = point
    return Line.from_samples(*random_line(elements, hurst, m, 3), m)


def solved(point, load, guess=None):
    """Return (d by spans, number of sweeps, d of the plain solver with its tolerance)."""
    _, _, m, speed = point
    line = line_at(point)
    law = SCHEMES["exponential"](1.0 / (m * speed))
    spans = spans_of_line(stack_of(line.z[None], line.slope[None]), 0)
    thresholds = thresholds_of(line.z, law.stiffness).contact
    problem = decay_factors(law), line.z, spans, thresholds, load * line.z.size
    steps = 0
    if guess is None:
        guess, steps = approach_indentation(*problem), APPROACH_STEPS
    d, after = span_indentation(*problem, guess, np.empty(line.z.size // SPAN + 1))
    plain = steady_sliding(law, line.z, load * line.z.size)[0].d
    # The plain solver knows the load to 1e-15 of d times the stiffness, which exceeds m vbar.
    return (
        d,
        steps + after,
        pytest.approx(plain, rel=1e-12 + 1e-15 * (1 + m * speed) * plain / load),
    )


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("point", LINES, ids=str)
def test_few_sweeps_lead_to_the_indentation(point, load):
    d, sweeps, plain = solved(point, load)
    assert d == plain
    assert sweeps <= 7


@settings(max_examples=size(200, 20))
@example((0.7, 50, 2, 1e-12), -100.0, 0.0)
@example((0.7, 50, 2, 1e12), -100.0, 0.0)
@example((0.7, 50, 2, 1.0), 100.0, 0.0)
@example((0.0, 5, 1, 3.0), 0.875, 4.0)
@example((0.0, 5, 1, 3.0), 1.0, 5.75)
@given(st.sampled_from(LINES), st.floats(-9.0, 3.0), st.floats(-12.0, 6.0))
def test_any_guess_leads_to_the_root(point, load, guess):
    d, sweeps, _ = solved(point, 10.0**load, 10.0**guess)
    # Each search may err by LOAD_TOLERANCE of the load. The force is a convex function of the depth
    # and vanishes with it, so it is at most its slope times the depth. The relative error of the
    # depth is thus at most LOAD_TOLERANCE. A first step that ends the search rounds as the guess.
    error = 2.0 * LOAD_TOLERANCE * (d - line_at(point).z.min()) + 1e-15 * (1.0 + 10.0**guess)
    assert d == pytest.approx(solved(point, 10.0**load)[0], rel=0.0, abs=error)
    assert sweeps <= (16 if abs(load) < 100.0 else 40)
