"""Errors that a user can correct: reported as one line each, with exit status 2."""

import errno
import re
from collections.abc import Iterable
from difflib import get_close_matches
from types import TracebackType
from typing import Self

MAX_LINE_CHARACTERS = 600
LEAST_LIKENESS = 0.65  # of names, as in difflib, for a suggestion
NOT_MAPPED = "failed to map segment|[Cc]annot allocate memory"  # by the loader of libraries
# By Python, of extension modules that do not check an allocation:
NO_EXCEPTION = "without (setting an exception|exception set)"


class UserError(Exception):
    """Invalid input or an unusable environment; the message names the remedy.

    The message is one line, rarely a table. Control characters are escaped.
    """

    place: str = ""  # file and line of the faulty key, if known

    def __init__(self, *lines: str) -> None:
        """Store the lines of the message."""
        super().__init__(*map(_shown, lines))

    @property
    def errors(self) -> "list[UserError]":
        """The individual errors."""
        return [self]

    def __str__(self) -> str:
        """Return the message."""
        return "\n".join(self.args)


class UserErrors(UserError):
    """Several errors, each with its own line."""

    def __init__(self, errors: Iterable[UserError]) -> None:
        """Store the errors."""
        self._errors = list(errors)
        super().__init__(*(line for error in self._errors for line in error.args))

    @property
    def errors(self) -> list[UserError]:
        """The individual errors."""
        return self._errors


class ErrorCollector:
    """Collector of user errors from ``with`` blocks; ``raise_collected`` raises them together."""

    def __init__(self) -> None:
        """Begin without errors."""
        self.errors: list[UserError] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None
    ) -> bool:
        if isinstance(error, UserError):
            self.errors += error.errors
        return isinstance(error, UserError)

    def raise_collected(self) -> None:
        """Raise the collected errors as one UserError, if there are any."""
        if len(self.errors) == 1:
            raise self.errors[0]
        if self.errors:
            raise UserErrors(self.errors)


def lacks_memory(error: BaseException | None) -> bool:
    """Return whether an error means that memory could not be allocated."""
    if isinstance(error, SystemError):
        return bool(re.search(NO_EXCEPTION, str(error))) or lacks_memory(error.__cause__)
    if isinstance(error, ImportError):
        return bool(re.search(NOT_MAPPED, str(error)))
    return isinstance(error, MemoryError) or getattr(error, "errno", 0) == errno.ENOMEM


def did_you_mean(name: object, known: Iterable[str]) -> str:
    """Return a hint with the most similar known name, for the end of a message, or ""."""
    nearest = get_close_matches(str(name), list(map(str, known)), 1, LEAST_LIKENESS)
    return f"; did you mean {nearest[0]}?" if nearest else ""


def printable(text: str) -> str:
    """Return a text with its control characters escaped, so that a terminal does not obey them."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, in the plural unless it is one: 1 worker, 2 workers."""
    return f"{number} {noun}{'s' * (number != 1)}"


def _shown(line: str) -> str:
    """Return a line for printing; a very long one is shortened in the middle."""
    text = printable(str(line))
    half = MAX_LINE_CHARACTERS // 2
    return text if len(text) <= MAX_LINE_CHARACTERS else f"{text[:half]} … {text[-half:]}"
