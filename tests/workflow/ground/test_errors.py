"""What a user can put right: one line that any terminal can show."""

import pytest

from elastomer_friction.workflow.ground.errors import (
    LONGEST,
    ErrorCollector,
    UserError,
    UserErrors,
    counted,
    did_you_mean,
)


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


def test_several_errors_are_raised_as_one_and_one_as_itself():
    complaints, first, second = ErrorCollector(), UserError("a = 1: wrong"), UserError("b: missing")
    complaints.end()
    with complaints:
        raise first
    with pytest.raises(UserError) as caught:
        complaints.end()
    assert caught.value is first
    with complaints:
        raise UserErrors([second])
    with pytest.raises(UserErrors, match=r"^a = 1: wrong\nb: missing$") as caught:
        complaints.end()
    assert caught.value.errors == [first, second]
    with pytest.raises(ZeroDivisionError), complaints:
        _ = 1 / 0


def test_what_comes_nearest_is_named():
    assert did_you_mean("hurts", ["hurst", "spacing"]) == "; did you mean hurst?"
    assert did_you_mean("moon", ["local", "slurm"]) == ""
    assert did_you_mean(7, ["linear"]) == ""


def test_one_thing_is_one():
    assert [counted(n, "worker") for n in (0, 1, 2)] == ["0 workers", "1 worker", "2 workers"]
