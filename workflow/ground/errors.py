"""What a user can put right: reported as one line, exit status 2."""

from collections.abc import Iterable
from difflib import get_close_matches
from types import TracebackType
from typing import Self

LONGEST = 600  # characters of a line


class UserError(Exception):
    """Wrong input or an environment that cannot be used; the message says what would be right.

    One line, but for the odd table. Whatever is put into a line, any terminal can show it.
    """

    place: str = ""  # file and line of what is wrong, where that is known

    def __init__(self, *lines: str) -> None:
        """Keep the lines of the message."""
        super().__init__(*map(_shown, lines))

    @property
    def errors(self) -> "list[UserError]":
        """Return what is wrong, one by one."""
        return [self]

    def __str__(self) -> str:
        """Return the message."""
        return "\n".join(self.args)


class UserErrors(UserError):
    """Several things that are wrong at once, each with its line."""

    def __init__(self, errors: Iterable[UserError]) -> None:
        """Keep the errors."""
        self._errors = list(errors)
        super().__init__(*(line for error in self._errors for line in error.args))

    @property
    def errors(self) -> list[UserError]:
        """Return what is wrong, one by one."""
        return self._errors


class ErrorCollector:
    """Collects what is wrong: each ``with complaints:`` goes on after it, ``end`` raises it all."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self.found: list[UserError] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None
    ) -> bool:
        if isinstance(error, UserError):
            self.found += error.errors
        return isinstance(error, UserError)

    def end(self) -> None:
        """Raise the one UserError that was found, or all as one."""
        if len(self.found) == 1:
            raise self.found[0]
        if self.found:
            raise UserErrors(self.found)


def did_you_mean(name: object, known: Iterable[str]) -> str:
    """Return the end of a message that names what comes nearest; "" where nothing does."""
    nearest = get_close_matches(str(name), [str(each) for each in known], 1)
    return f"; did you mean {nearest[0]}?" if nearest else ""


def printable(text: str) -> str:
    """Return a text whose control characters, which a terminal would obey, are shown as numbers."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def counted(number: int, thing: str) -> str:
    """Return a number of things in words: 1 worker, 2 workers."""
    return f"{number} {thing}{'s' * (number != 1)}"


def _shown(line: str) -> str:
    """Return a line as it can be printed, cut in the middle where it is endless."""
    text = printable(str(line))
    half = LONGEST // 2
    return text if len(text) <= LONGEST else f"{text[:half]} … {text[-half:]}"
