"""All that is wrong with the keys of a study is said at once, at every scale."""

import pytest

from elastomer_friction.workflow.errors import UserErrors
from tests.support.small import TEXT, small_study

SEVERAL = """
[study]
sead = 1
realizations = 16

[material]
shear_modulus = -1e7

[scales.wide.grid]
normal_force = "much"

[scales.wide.numerics]
sceme = "exponential"

[scales.tall]
gird = {hurst = 0.3}

[compare.other]
scheme = "euler"
"""


def test_everything_is_said_at_once_in_the_order_of_the_file():
    with pytest.raises(UserErrors) as caught:
        small_study(text=SEVERAL)
    said = [str(error) for error in caught.value.errors]
    beginnings = [
        "study.sead: unknown key",
        "material.shear_modulus = -10000000.0: must be greater than zero",
        "compare.other.scheme = 'euler': must be one of",
        "scales.wide.grid.normal_force = 'much': must be a finite number",
        "scales.wide.numerics.sceme: unknown key",
        "scales.tall.gird: unknown key",
    ]
    assert len(said) == len(beginnings)
    for line, beginning in zip(said, beginnings, strict=True):
        assert line.startswith(beginning)
    assert str(caught.value).splitlines() == said
    assert [error.place.rpartition(" ")[2] for error in caught.value.errors] == [
        *("3)", "7)", "19)", "10)", "13)", "16)")
    ]


def test_all_missing_keys_of_a_table_are_said_at_once():
    lacking = TEXT.replace("hurst = [0.3, 0.7]\n", "").replace("roughness = 1e-5\n", "")
    with pytest.raises(UserErrors) as caught:
        small_study(text=lacking)
    assert [str(e) for e in caught.value.errors] == [
        "grid.hurst: missing",
        "grid.roughness: missing",
    ]


def test_what_values_come_to_together_is_left_to_the_scale_that_is_asked_for():
    large = TEXT + "[scales.fine.grid]\nspacing = 1e-12\n"
    assert small_study(text=large).name == "small"
    with pytest.raises(Exception, match=r"^grid.spacing = 1e-12: more than 1e\+08 elements"):
        small_study(text=large, scale="fine")
