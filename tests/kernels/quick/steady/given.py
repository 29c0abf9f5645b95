"""Lines, laws and what spans know of them, over the regimes of steady sliding."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Line, steady_sliding
from elastomer_friction.kernels.model.steady import sweep
from elastomer_friction.kernels.quick.steady.carry import carry, decay_of
from elastomer_friction.kernels.quick.steady.contacts import room_for
from elastomer_friction.kernels.quick.steady.spans import SPAN, TURN, Spans, fill_spans
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
    (0.7, 64, 1, 2e-3),  # e^-500 is nothing: the elastic contact
]
LOADS = (1e-6, 1e-3, 0.03, 0.3, 2.0, 40.0)  # Fbar, from a sample to full contact
on_every_line = pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
everywhere = pytest.mark.parametrize(
    "given", [(*point, load) for point in LINES for load in LOADS], ids=str
)


def line_of(hurst, elements, m, seed=3):
    """Return a random line."""
    return Line.from_samples(*random_line(elements, hurst, m, seed), m, band_limited=True)


def spans_of(z, slope):
    """Return the Spans of a line."""
    count = z.size // SPAN
    rows, whole = np.empty((count + 1, TURN + 1)), np.empty(4)
    spans = Spans(*(np.empty(count) for _ in range(4)), rows, whole, 0)
    return spans._replace(deepest=fill_spans(z, slope, spans))


def known(line, speed, scheme="exponential"):
    """Return (law, spans, thresholds) at vbar = speed."""
    law = SCHEMES[scheme](1.0 / (line.steps_per_spacing * speed))
    spans = spans_of(line.z, line.slope)
    return law, spans, thresholds_of(line.z, line.slope, speed, law.stiffness)


def touching(z, w, d):
    """Return the samples in contact, by the condition itself."""
    return z - np.asarray(w) < d


def both(line, speed, load, scheme="exponential"):
    """Return (d, the plain sweep's w and sums, carry's w, sums and contacts) at the load's d."""
    law, spans, own = known(line, speed, scheme)
    (_, d), _ = steady_sliding(law, line.z, load * line.z.size)
    plain, w = np.empty_like(line.z), np.empty_like(line.z)
    total, slope, count = sweep(law, line.z, d, spans.deepest, plain)
    contacts = room_for(line.slope, speed)
    round_the_line = decay_of(law), line.z, spans, own.stay, d
    found = carry(*round_the_line, contacts, None)
    expected = law.stiffness * total, law.stiffness * slope, count
    assert found == carry(*round_the_line, None, w)  # whatever is filled
    assert found == carry(*round_the_line, None, None)
    return d, plain, expected, w, found, contacts
