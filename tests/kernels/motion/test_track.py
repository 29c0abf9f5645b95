"""The line as the elements of the foundation see it, stage by stage."""

import numpy as np

from elastomer_friction.kernels.motion import track as module
from elastomer_friction.kernels.motion.fourier import Shifted
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Slide, steps_of
from elastomer_friction.kernels.motion.track import tracks
from tests.lines import random_line

PROGRAMME = (Slide(1.0, 3.3), Hold(1.0), Oscillation(0.0, 0.2, 0.3, 1), Slide(-2.0, 5.0))


def lines(z, slope, m, steps, start):
    """Return heights and slopes after every step, as concatenated from all stages."""
    rows = []
    for track in tracks(z, slope, m, steps, start):
        for s in range(0 if not rows else 1, track.dt.size + 1):
            begin = track.begin[s]
            rows.append([v[track.line[s], begin : begin + z.size] for v in (track.z, track.slope)])
    return np.array(rows)


def test_whole_samples_are_the_line_itself_read_from_elsewhere():
    z, slope = random_line(20, 0.7, 2, seed=1)
    steps = steps_of((Slide(1.0, 12.0), Slide(-1.0, 30.0)), 2)
    found = lines(z, slope, 2, steps, 0.0)
    for row, place in zip(found, np.append(0.0, steps.position), strict=True):
        np.testing.assert_array_equal(row, [np.roll(v, int(place)) for v in (z, slope)])


def test_fractions_are_shifted_and_stages_do_not_show(monkeypatch):
    z, slope = random_line(20, 0.7, 2, seed=1)
    steps = steps_of(PROGRAMME, 2, 0.4)
    found = lines(z, slope, 2, steps, 0.4)
    shifted = Shifted(z, slope, 2)
    for row, place in zip(found, np.append(0.4, steps.position), strict=True):
        whole = int(np.floor(place))
        expected = [np.roll(v, whole) for v in shifted.by(place - whole)]
        np.testing.assert_allclose(row, expected, atol=1e-14)
    monkeypatch.setattr(module, "LINES", 3)
    assert len(list(tracks(z, slope, 2, steps, 0.4))) > 10
    np.testing.assert_array_equal(lines(z, slope, 2, steps, 0.4), found)


def test_no_steps_still_show_where_the_line_is():
    z, slope = random_line(20, 0.7, 2, seed=1)
    (track,) = tracks(z, slope, 2, steps_of((), 2), 3.0)
    assert track.dt.size == 0
    np.testing.assert_array_equal(track.z[track.line[0], track.begin[0] :][:40], np.roll(z, 3))
