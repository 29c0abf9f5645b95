"""Read the table [cluster] of a study: where it is computed."""

import re
from dataclasses import fields

from workflow.axes import integer, positive
from workflow.errors import UserError
from workflow.place import LOCAL, SLURM, Place, walltime_seconds
from workflow.settings import as_text, check_keys

LEAST_WALLTIME = 60.0  # s


def read_place(table: dict) -> Place:
    """Return the place a table [cluster] describes. Raises UserError naming key and value."""
    names = tuple(field.name for field in fields(Place))
    check_keys("cluster.", table, names)
    found = {name: _value(f"cluster.{name}", name, value) for name, value in table.items()}
    return Place(**found)


def _value(key: str, name: str, value: object) -> object:
    if name in ("jobs", "cores"):
        return integer(key, value, 1)
    if name == "patience":
        return positive(key, value)
    if name == "prologue":
        lines = value if isinstance(value, list) else [value]
        return tuple(as_text(key, line) for line in lines)
    text = as_text(key, value)
    if name == "where" and text not in (LOCAL, SLURM) and "://" not in text:
        raise UserError(f"{key} = {text!r}: must be local, slurm or tcp://host:port")
    if name == "memory" and not re.fullmatch(r"[0-9.]+ ?[kMGT]i?B", text):
        raise UserError(f'{key} = {text!r}: must be a size, as "4GB"')
    if name == "walltime":
        _check_walltime(key, text)
    return text


def _check_walltime(key: str, text: str) -> None:
    try:
        seconds = walltime_seconds(text)
    except ValueError:
        raise UserError(f'{key} = {text!r}: must be a time, as "12:00:00"') from None
    if seconds < LEAST_WALLTIME:
        raise UserError(f"{key} = {text!r}: must be at least {LEAST_WALLTIME:.0f} s")
