"""What values a key may have, and its default, in words."""

import json
from collections.abc import Callable
from functools import partial
from typing import Any

from .checks import (
    UNBOUNDED,
    as_text,
    checked_values,
    choice,
    flag,
    integer,
    number,
    one_or_several,
    positive,
    within,
)
from .key import REQUIRED, Key

PLAIN: dict[Callable[..., Any], str] = {
    positive: "a number above 0",
    number: "a number",
    flag: "`true` or `false`",
    as_text: "text",
}


def values_of(key: Key) -> str:
    """Return in words what a key takes."""
    return key.values or _taken(key.check)


def _taken(check: Callable[..., Any]) -> str:
    """Return in words what a check takes; "" where its key must say so itself."""
    if not isinstance(check, partial):
        return PLAIN.get(check, "")
    given = check.keywords
    if check.func is within:
        return f"a number from {given['least']:g} to {given['most']:g}"
    if check.func is integer:
        most = given.get("most", UNBOUNDED)
        if most == UNBOUNDED:
            return f"a whole number, at least {given['least']}"
        return f"a whole number from {given['least']} to {most}"
    if check.func is choice:
        *others, last = (f'`"{known}"`' for known in given["known"])
        return f"{', '.join(others)} or {last}"
    if check.func in (checked_values, one_or_several):
        return f"{_taken(check.args[0])}, or a list or range"
    return ""


def default_of(key: Key) -> str:
    """Return the default of a key in words or as TOML has it; "none" where it is empty."""
    if key.usual:
        return key.usual
    if key.default is REQUIRED:
        return "required"
    if key.default in (None, "", ()):
        return "none"
    if isinstance(key.default, bool):
        return f"`{str(key.default).lower()}`"
    told = as_toml(key.default)
    return f"`{told}`" if isinstance(key.default, str) else told


def as_toml(value: object) -> str:
    """Return a number, a text or a list of them as TOML has it."""
    if isinstance(value, list):
        return f"[{', '.join(map(as_toml, value))}]"
    return f"{value:g}" if isinstance(value, float) else json.dumps(value)
