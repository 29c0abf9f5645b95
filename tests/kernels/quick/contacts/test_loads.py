"""Many loads at one speed, on a line or a part of it: each as alone; full contact by criterion."""

import numpy as np
import pytest

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
from elastomer_friction.kernels.quick.contacts.part import NONE, Part, slide_on
from elastomer_friction.kernels.quick.contacts.refined import curvatures_of
from elastomer_friction.kernels.quick.steady.carry import NO_GAPS, decay_of
from elastomer_friction.kernels.quick.steady.spans import SPAN
from elastomer_friction.kernels.quick.steady.stack import stack_of
from tests.kernels.quick.steady.given import known, line_of, on_every_line, touching

SEVERAL = np.geomspace(1e-4, 60.0, 12)


def slid(line, speed, several, criterion=True):
    """Return what is Found under loads Fbar, with the speed 1.2 times as large as the next."""
    law, spans, own = known(line, speed)
    there = known(line, 1.2 * speed)[2]
    if not criterion:
        own, there = (at._replace(stay_all=np.inf, press_all=np.inf) for at in (own, there))
    press = np.append(there.press, there.press_all)[None]
    later = decay_of(known(line, 1.2 * speed)[0]).once
    speeds = Speeds(speed, own, np.array([1.2 * speed]), press, np.array([later]))
    none = np.full(several.size, np.nan)
    total, how = several * line.z.size, How(float(line.steps_per_spacing), 0.0, True)
    shapes = 6, 1, 1, line.z.size // SPAN + 1, 1
    into = Found(*(np.full((several.size, width), np.nan) for width in shapes))
    slide(decay_of(law), line.z, line.slope, spans, speeds, total, none, how, NO_GAPS, into)
    return into


@on_every_line
def test_every_load_is_as_alone_and_full_contact_where_all_samples_touch(hurst, elements, m, speed):
    line = line_of(hurst, elements, m)
    found, jumps, rates, entered, ahead = slid(line, speed, SEVERAL)
    above = np.append(np.arange(SPAN, line.z.size, SPAN), 0)
    for i, load in enumerate(SEVERAL):
        alone, jump, rate, enter, next_d = slid(line, speed, SEVERAL[i : i + 1])
        np.testing.assert_array_equal(alone[0], found[i])
        np.testing.assert_array_equal(jump[0], jumps[i])
        np.testing.assert_array_equal(rate[0], rates[i])
        np.testing.assert_array_equal(next_d[0], ahead[i])
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


SPEED, LOADS = 5.0, (1e-3, 0.3)
LINE = line_of(0.7, 64, 4)


def slide_part(at, load, fold=1):
    """Return (part, what slide_on returns) of some intervals of the line, each of ``fold``."""
    law, _, _ = known(LINE, SPEED * fold)
    low = np.zeros(LINE.z.size, bool)
    stack = stack_of(LINE.z.reshape(1, -1), LINE.slope.reshape(1, -1))
    part = Part(stack, curvatures_of(LINE), np.asarray(at), fold, low)
    if not len(at):
        part = Part(stack)
    loads, guesses = np.array([load * LINE.z.size * fold]), np.array([[np.nan]])
    speeds, how = (SPEED, np.array([1.2 * SPEED]), NONE), How(4.0 * fold, 0.0, True)
    return part, slide_on(law, part, speeds, loads, guesses, how)


@pytest.mark.parametrize("load", LOADS)
def test_all_intervals_with_one_sample_each_are_the_line_itself(load):
    _, (_, _, whole, nowhere) = slide_part([], load)
    _, (_, _, found, missed) = slide_part(np.arange(LINE.z.size), load)
    assert missed == nowhere == 0
    for one, other in zip(whole, found, strict=True):
        np.testing.assert_array_equal(one, other)


def test_only_the_line_itself_can_be_in_full_contact():
    _, (_, _, (whole, *_), _) = slide_part([], 1e3)
    _, (_, _, (found, *_), _) = slide_part(np.arange(LINE.z.size), 1e3)
    assert (whole[0, 0, FULL], found[0, 0, FULL]) == (1.0, 0.0)
    assert found[0, 0, INDENTATION] == pytest.approx(whole[0, 0, INDENTATION], rel=1e-12)


def test_what_a_part_lacks_is_marked():
    deepest = int(np.argmin(LINE.z))
    some = np.unique((deepest + np.arange(-2, 2)) % LINE.z.size)
    part, (_, _, _, missed) = slide_part(some, LOADS[1], fold=8)
    assert missed > 0
    assert part.low.sum() > some.size
