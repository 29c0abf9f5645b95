"""Rows of the store: every value has its place, and comes back with its shape."""

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Quantities, Slide, Spectrum
from elastomer_friction.workflow.simulate.layout import BINS, EDGES, row_layout, row_width, unpack
from elastomer_friction.workflow.simulate.tasks import Problem, Recording, Task

SPECTRUM = Spectrum((2.0, 1.0), (0.1, 1.0), 0.0)
PROGRAMME = (Slide(1.0, 4.0), Hold(2.0), Slide(1.0, 4.0))
PROBLEM = Problem(0.7, 16, 0.1, 1.0, 1.0, spectrum=SPECTRUM, programme=PROGRAMME)
TASK = Task(PROBLEM, 2, 8, "")
ASKED = ("trace", "energy", "contact_lengths", "snapshots", "state")


@pytest.mark.parametrize("count", range(6))
def test_parts_follow_each_other_without_gaps_and_unpack_to_their_shapes(count):
    recording = Recording(20, asked=ASKED[:count])
    quantities = Quantities(initial_rate=True)
    places = row_layout(TASK, quantities, "exponential", recording)
    width = row_width(places)
    rows = np.arange(3.0 * width).reshape(3, width)
    parts = unpack(rows, places)
    blocks = unpack(np.stack([rows, -rows], axis=1), places)  # of tasks and blocks
    assert all(np.array_equal(blocks[name][:, 1], -parts[name]) for name in parts)
    joined = np.concatenate([part.reshape(3, -1) for part in parts.values()], axis=1)
    assert np.array_equal(joined, rows)
    assert parts["curve"].shape == (3, 19)
    assert parts["initial_rate"].shape == (3,)


def test_without_a_march_a_row_is_empty():
    asked = Quantities(relaxation=False)
    assert row_width(row_layout(TASK, asked, "exponential", Recording(64))) == 0


def test_contact_lengths_are_counted_from_a_sixteenth_of_a_spacing_on():
    assert EDGES.size == BINS + 1
    assert EDGES[:5].tolist()[::2] == [0.0625, 0.125, 0.25]
    np.testing.assert_allclose(EDGES[1:] / EDGES[:-1], np.sqrt(2.0), rtol=1e-15)
