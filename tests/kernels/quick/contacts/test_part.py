"""Sliding on a part of a line: all of it is the line itself, and what a part lacks is found."""

import numpy as np
import pytest

from elastomer_friction.kernels.quick.contacts.loads import FULL, INDENTATION, How
from elastomer_friction.kernels.quick.contacts.part import NONE, Part, slide_on
from elastomer_friction.kernels.quick.contacts.refined import curvatures_of
from elastomer_friction.kernels.quick.steady.stack import stack_of
from tests.kernels.quick.steady.given import known, line_of

SPEED, LOADS = 5.0, (1e-3, 0.3)
LINE = line_of(0.7, 64, 4)


def slide(at, load, fold=1):
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
    _, (_, _, whole, nowhere) = slide([], load)
    _, (_, _, found, missed) = slide(np.arange(LINE.z.size), load)
    assert missed == nowhere == 0
    for one, other in zip(whole, found, strict=True):
        np.testing.assert_array_equal(one, other)


def test_only_the_line_itself_can_be_in_full_contact():
    _, (_, _, (whole, *_), _) = slide([], 1e3)
    _, (_, _, (found, *_), _) = slide(np.arange(LINE.z.size), 1e3)
    assert (whole[0, 0, FULL], found[0, 0, FULL]) == (1.0, 0.0)
    assert found[0, 0, INDENTATION] == pytest.approx(whole[0, 0, INDENTATION], rel=1e-12)


def test_what_a_part_lacks_is_marked():
    deepest = int(np.argmin(LINE.z))
    some = np.unique((deepest + np.arange(-2, 2)) % LINE.z.size)
    part, (_, _, _, missed) = slide(some, LOADS[1], fold=8)
    assert missed > 0
    assert part.low.sum() > some.size
