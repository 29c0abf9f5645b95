"""Many loads at one speed on a line: each as alone; full contact by criterion."""

import numpy as np

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.contacts.loads import (
    CONTACT,
    FULL,
    INDENTATION,
    MU,
    SAMPLES,
    SWEEPS,
    Found,
    How,
    Speeds,
    slide,
)
from elastomer_friction.kernels.quick.steady.carry import decay_of
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.steady.given import known, line_of, on_every_line, touching

SEVERAL = np.geomspace(1e-4, 60.0, 12)


def slid(line, speed, several, criterion=True):
    """Return what is Found under loads Fbar, with the speed 1.2 times as large as the next."""
    law, spans, own = known(line, speed)
    there = known(line, 1.2 * speed)[2]
    if not criterion:
        own, there = (at._replace(stay_all=np.inf, press_all=np.inf) for at in (own, there))
    press = np.append(there.press, there.press_all)[None]
    speeds = Speeds(speed, own, np.array([1.2 * speed]), press)
    total, how = several * line.z.size, How(float(line.steps_per_spacing), 0.0, True, False)
    shapes = 7, 1, 1, line.z.size // SPAN + 1
    into = Found(*(np.full((several.size, width), np.nan) for width in shapes))
    slide(decay_of(law), line.z, line.slope, spans, speeds, total, how, into)
    return into


@on_every_line
def test_every_load_is_as_alone_and_full_contact_where_all_samples_touch(hurst, elements, m, speed):
    line = line_of(hurst, elements, m)
    found, jumps, rates, entered = slid(line, speed, SEVERAL)
    above = np.append(np.arange(SPAN, line.z.size, SPAN), 0)
    for i, load in enumerate(SEVERAL):
        alone, jump, rate, enter = slid(line, speed, SEVERAL[i : i + 1])
        np.testing.assert_array_equal(alone[0], found[i])
        np.testing.assert_array_equal(jump[0], jumps[i])
        np.testing.assert_array_equal(rate[0], rates[i])
        np.testing.assert_array_equal(enter[0][: above.size], entered[i][: above.size])
        (w, d), _ = steady_sliding(known(line, speed)[0], line.z, load * line.z.size)
        assert (found[i, FULL] == 1.0) == touching(line.z, w, d).all()
        assert (found[i, SWEEPS] == 0.0) == (found[i, FULL] == 1.0)
        upstream = np.minimum(w, line.z - d)[above]
        np.testing.assert_allclose(entered[i][: above.size], upstream, rtol=1e-9, atol=1e-150)


def test_nothing_but_speed_is_changed_by_the_closed_form():
    """Full contact found by the general path: its criterion never met."""
    line = line_of(0.7, 100, 4)
    closed, general = slid(line, 2.0, SEVERAL), slid(line, 2.0, SEVERAL, criterion=False)
    full = closed[0][:, FULL] == 1.0
    assert full.any()
    assert not general[0][:, FULL].any()
    for column in (INDENTATION, MU, CONTACT, SAMPLES):
        np.testing.assert_allclose(general[0][:, column], closed[0][:, column], rtol=1e-12)
    np.testing.assert_allclose(general[1], closed[1], rtol=1e-12, atol=1e-14)
