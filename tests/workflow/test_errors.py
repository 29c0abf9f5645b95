"""What a user can put right: one line that any terminal can show."""

from workflow.errors import LONGEST, UserError


def test_a_message_is_one_line_of_what_can_be_shown():
    assert str(UserError("grid.hurst = 'a\nb\x1b[0m': µ")) == "grid.hurst = 'a\\nb\\x1b[0m': µ"


def test_an_endless_line_is_cut_in_the_middle():
    message = str(UserError("begin " + "x" * 10**5 + " end"))
    assert len(message) <= LONGEST + 3
    assert message.startswith("begin x")
    assert " … " in message
    assert message.endswith("x end")


def test_a_table_keeps_its_lines():
    assert str(UserError("there", "here")) == "there\nhere"
