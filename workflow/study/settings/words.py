"""The default of a key, and any value of one, in words."""

import json

from .key import REQUIRED, Key


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
