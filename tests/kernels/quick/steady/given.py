"""Lines, laws and spans over the regimes of steady sliding."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Line
from elastomer_friction.kernels.quick.steady.spans import SPAN, SPAN_COLUMNS, Spans, fill_spans
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of
from tests.lines import random_line

# (Hurst exponent, elements, samples per spacing, vbar): patches narrower and wider than a span,
# fewer samples than a span, whole spans and others
LINES = [
    (0.0, 5, 1, 3.0),
    (0.0, 64, 1, 30.0),
    (0.3, 77, 2, 0.05),
    (0.7, 100, 4, 2.0),
    (1.0, 48, 8, 500.0),
    (0.7, 64, 1, 2e-3),  # e^-500 is zero: the elastic contact
]
on_every_line = pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)


def line_of(hurst, elements, m, seed=3):
    """Return a random line."""
    return Line.from_samples(*random_line(elements, hurst, m, seed), m, band_limited=True)


def spans_of(z, slope):
    """Return the Spans of a line."""
    count = z.size // SPAN
    rows, line_sums = np.empty((count + 1, SPAN_COLUMNS)), np.empty(4)
    spans = Spans(*(np.empty(count) for _ in range(4)), rows, line_sums, 0)
    return spans._replace(deepest=fill_spans(z, slope, spans))


def constants_at(line, speed, scheme="exponential"):
    """Return (law, spans, thresholds) at vbar = speed."""
    law = SCHEMES[scheme](1.0 / (line.steps_per_spacing * speed))
    spans = spans_of(line.z, line.slope)
    return law, spans, thresholds_of(line.z, line.slope, speed, law.stiffness)


def touching(z, w, d):
    """Return the samples in contact, by the condition of contact."""
    return z - np.asarray(w) < d
