"""The states from which scenes start."""

import numpy as np
import pytest

from elastomer_friction.kernels.rheology.forms import FORMS
from elastomer_friction.kernels.rheology.law import law_of, predict
from elastomer_friction.kernels.scene.begin import fresh, relaxed, steady
from tests.kernels.scene.given import DAMPED, MATERIALS, PRONY, SOLID, a_line

LINE = a_line()
LOAD = 0.3 * LINE.z.size


@pytest.mark.parametrize("scheme", FORMS)
@pytest.mark.parametrize("name", MATERIALS)
def test_relaxed_elements_stay_where_they_are(scheme, name):
    form = FORMS[scheme](MATERIALS[name])
    elements = relaxed(form, LINE.z, LOAD, np.nan)
    np.testing.assert_allclose(elements.p, np.maximum(0.0, elements.d - LINE.z), atol=1e-12)
    assert elements.p.sum() == pytest.approx(LOAD, rel=1e-12)
    law, w = law_of(form, 0.3), np.empty(LINE.z.size)
    predict(law, elements.memory, elements.p, w)
    again = law.stiffness * np.maximum(0.0, elements.d - (LINE.z - w))
    np.testing.assert_allclose(again, elements.p, atol=1e-11)


@pytest.mark.parametrize("scheme", FORMS)
@pytest.mark.parametrize("spectrum", [SOLID, PRONY], ids=["solid", "prony"])
def test_fresh_elements_are_glassy_and_keep_their_force_for_a_moment(scheme, spectrum):
    form = FORMS[scheme](spectrum)
    stiffness = 1.0 + sum(spectrum.moduli)
    elements = fresh(form, spectrum, LINE.z, LOAD, np.nan)
    np.testing.assert_allclose(
        elements.p, stiffness * np.maximum(0.0, elements.d - LINE.z), rtol=1e-9
    )
    assert elements.p.sum() == pytest.approx(LOAD, rel=1e-12)
    law, w = law_of(form, 1e-7), np.empty(LINE.z.size)
    predict(law, elements.memory, elements.p, w)
    again = law.stiffness * np.maximum(0.0, elements.d - (LINE.z - w))
    np.testing.assert_allclose(again, elements.p, rtol=1e-3, atol=1e-6)


def test_a_dashpot_cannot_be_fresh():
    with pytest.raises(ValueError, match="a dashpot carries any load at first"):
        fresh(FORMS["exponential"](DAMPED), DAMPED, LINE.z, LOAD, np.nan)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("speed", [2.0, -2.0])
def test_a_steady_state_under_a_load_is_that_at_its_indentation(name, speed):
    one = steady("exponential", MATERIALS[name], LINE.z, speed, LOAD, np.nan)
    two = steady("exponential", MATERIALS[name], LINE.z, speed, None, one.d)
    np.testing.assert_allclose(two.p, one.p, rtol=1e-6, atol=1e-9)
    assert one.p.sum() == pytest.approx(LOAD, rel=1e-10)


@pytest.mark.parametrize("name", MATERIALS)
def test_above_the_foundation_nothing_touches(name):
    elements = steady("exponential", MATERIALS[name], LINE.z, 2.0, None, -0.1)
    assert not elements.p.any()
    assert not elements.memory.any()
