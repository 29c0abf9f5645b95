"""The two numbers that say whether an element touches."""

import pytest

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.quick.march.given import a_of, advance

LAW = SCHEMES["exponential"](0.3)


def test_they_are_differences_with_one_term_decayed():
    assert advance(LAW, 3.0, 2.0) == pytest.approx(3.0 - LAW.decay * 2.0, rel=1e-14)
    assert a_of(LAW, 3.0, 2.0) == pytest.approx(3.0 - LAW.decay * 2.0, rel=1e-14)


def test_no_digits_are_lost_where_hardly_anything_decays():
    law = SCHEMES["exponential"](1e-12)
    assert advance(law, 5.0, 5.0) == pytest.approx(5.0 / law.stiffness, rel=1e-15)
