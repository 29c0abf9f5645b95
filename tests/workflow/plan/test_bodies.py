"""What of a study follows from its body: the normal force of a pressure, and the modulus E*."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.problems import distinct_problems
from tests.support.small import TEXT, small_study

PRESSED = TEXT.replace(
    "normal_force = [0.04, 0.4]\nspacing", "normal_pressure = [2e4, 4e4]\nspacing"
)


def loads(*settings, label="", **how):
    """Return F_N/(E* L h) of the two pressures, or forces, of the small study."""
    problems, index = distinct_problems(small_study(*settings, **how), label)
    return np.array([problems[row].load for row in index[0, :, 0, 0, 0, 0]])


@pytest.mark.parametrize(("surface", "longest"), [([], 0.01), (["surface.rolloff=1e-3"], 1e-3)])
def test_a_pressure_acts_on_the_longest_wave_times_the_length(surface, longest):
    found = small_study(*surface, text=PRESSED).grid["normal_force"]
    assert found == pytest.approx([2e4 * longest * 0.01, 4e4 * longest * 0.01], rel=1e-15)


def test_on_a_half_space_a_pressure_acts_on_the_square_whatever_the_rolloff():
    study = small_study("surface.rolloff=1e-3", "scene.body=half-space", text=PRESSED)
    assert study.grid["normal_force"] == pytest.approx([2.0, 4.0], rel=1e-15)


def test_bodies_that_are_compared_are_pressed_alike():
    rolled = ("surface.rolloff=1e-3", "scene.body=half-space")
    both = (*rolled, "compare.coarse.body=foundation")
    assert loads(*both, text=PRESSED) == pytest.approx(loads(*rolled, text=PRESSED), rel=1e-12)
    alone = loads("surface.rolloff=1e-3", text=PRESSED)
    assert loads(*both, label="coarse", text=PRESSED) == pytest.approx(alone, rel=1e-12)


def test_a_compressible_elastomer_is_softer_in_contact():
    """E* = 2 G/(1 - nu): 4 G at 1/2, half of it at 0."""
    assert np.array_equal(loads("material.poisson=0.5"), loads())
    assert loads("material.poisson=0.0") == pytest.approx(2.0 * loads(), rel=1e-12)
    assert loads("material.poisson=0.3") == pytest.approx(1.4 * loads(), rel=1e-12)
