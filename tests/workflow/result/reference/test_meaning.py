"""A meaning has no sign where a value has none."""

from elastomer_friction.workflow.result.reference.meaning import Meaning


def test_a_value_has_no_sign_unless_that_is_said():
    assert Meaning("A number.").sign == ""
