"""A key of a table, stated once: its check, what it means, its unit and its default.

A table of a study is declared as name -> Key, from which its reader, the JSON schema and the page
of reference follow. A value is checked once, by ``checked``.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from ...ground import Complaints, UserError, did_you_mean
from .checks import as_table

REQUIRED = object()


@dataclass(frozen=True)
class Key:
    """One setting: check(key, value) returns what is meant by a value or raises UserError.

    Texts are full sentences. What the check and the default say by themselves, values, usual and
    schema leave out.
    """

    check: Callable[[str, object], Any]
    means: str = ""  # what the key says
    doubled: str = ""  # of a number: what changes when it is doubled
    unit: str = ""
    default: Any = REQUIRED  # where the key is left out
    values: str = ""  # what it may be, in words
    usual: str = ""  # the default, in words
    schema: Mapping[str, Any] | None = None  # what it may be, as JSON schema


def read_table(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value for all ``keys`` of a table; ``where`` is its name.

    Raises UserError for what is no table, an unknown key, a refused value and a missing key.
    """
    return filled(where, checked(where, table, keys), keys)


def checked(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value for what a table holds. Raises UserError likewise."""
    given, complaints, found = as_table(where, table), Complaints(), {}
    for name, value in given.items():
        with complaints:
            check_keys(f"{where}.", [name], keys)
            found[name] = keys[name].check(f"{where}.{name}", value)
    complaints.end()
    return found


def filled(where: str, given: Mapping[str, Any], keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return checked values with the defaults of what was left out. Raises UserError for a gap."""
    complaints = Complaints()
    for name, key in keys.items():
        with complaints:
            if name not in given and key.default is REQUIRED:
                raise UserError(f"{where}.{name}: missing")
    complaints.end()
    return {name: given.get(name, key.default) for name, key in keys.items()}


def check_keys(where: str, table: Iterable[str], known: Iterable[str]) -> None:
    """Raise UserError where a table holds a key that is not known; ``where`` goes before it."""
    for key in table:
        if key not in known:
            raise UserError(
                f"{where}{key}: unknown key; known are {', '.join(known)}{did_you_mean(key, known)}"
            )
