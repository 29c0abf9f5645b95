"""A text says what a key means; the rest is taken from its table where it says nothing."""

from elastomer_friction.workflow.study.reference.text import Text


def test_unit_values_and_default_are_those_of_the_table_unless_given():
    assert Text("What.", "Then what.")[2:] == ("", "", "")
