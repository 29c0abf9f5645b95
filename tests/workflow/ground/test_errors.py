"""Errors for the user: one printable line each."""

import errno

import pytest

from elastomer_friction.workflow.ground.errors import (
    MAX_LINE_CHARACTERS,
    ErrorCollector,
    UserError,
    UserErrors,
    counted,
    did_you_mean,
    lacks_memory,
)


def test_a_message_is_one_line_with_control_characters_escaped():
    assert str(UserError("grid.hurst = 'a\nb\x1b[0m': µ")) == "grid.hurst = 'a\\nb\\x1b[0m': µ"


def test_a_very_long_line_is_shortened_in_the_middle():
    message = str(UserError("begin " + "x" * 10**5 + " end"))
    assert len(message) <= MAX_LINE_CHARACTERS + 3
    assert message.startswith("begin x")
    assert " … " in message
    assert message.endswith("x end")


def test_a_table_keeps_its_lines():
    assert str(UserError("there", "here")) == "there\nhere"


def test_several_errors_are_raised_as_one_and_one_as_itself():
    collector, first, second = ErrorCollector(), UserError("a = 1: wrong"), UserError("b: missing")
    collector.raise_collected()
    with collector:
        raise first
    with pytest.raises(UserError) as caught:
        collector.raise_collected()
    assert caught.value is first
    with collector:
        raise UserErrors([second])
    with pytest.raises(UserErrors, match=r"^a = 1: wrong\nb: missing$") as caught:
        collector.raise_collected()
    assert caught.value.errors == [first, second]
    with pytest.raises(ZeroDivisionError), collector:
        _ = 1 / 0


def test_the_most_similar_name_is_suggested():
    assert did_you_mean("hurts", ["hurst", "spacing"]) == "; did you mean hurst?"
    assert did_you_mean("moon", ["local", "slurm"]) == ""
    assert did_you_mean(7, ["linear"]) == ""


def test_a_noun_is_singular_after_one():
    assert [counted(n, "worker") for n in (0, 1, 2)] == ["0 workers", "1 worker", "2 workers"]


MAPPED = "a.so: failed to map segment from shared object"
SILENT = "<function f> returned NULL without setting an exception"
WITH_CAUSE = SystemError("<function f> returned a result with an exception set")
WITH_CAUSE.__cause__ = MemoryError()


@pytest.mark.parametrize(
    ("error", "expected"),
    [
        (MemoryError(), True),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), True),
        (ImportError(MAPPED), True),
        (SystemError(SILENT), True),
        (SystemError("error return without exception set"), True),
        (WITH_CAUSE, True),
        (OSError(errno.EIO, "Input/output error"), False),
        (ImportError("No module named 'a'"), False),
        (SystemError("bad argument to internal function"), False),
        (RuntimeError(MAPPED), False),
        (None, False),
    ],
)
def test_only_errors_of_allocation_are_taken_for_lack_of_memory(error, expected):
    assert lacks_memory(error) is expected
