"""In which line of a TOML file a key stands, for messages. Knows headers and keys, no values."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import UserError

HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]#]+?)\s*\]\]?\s*(?:#.*)?$")
KEY = re.compile(r"\s*([\w.\"'-]+)\s*=")
NAMED = re.compile(r"([\w.\"\[\]-]+?)(?: = |: | holds )")  # what a message begins with
INDEX = re.compile(r"\[\d+\]")


@contextmanager
def placed(path: Path, scale: str, settings: list[str]) -> Iterator[None]:
    """Give every UserError that is raised within its place: the file, and the line of its key.

    scale : the one in force. settings : "table.key=value" overrides, which stand in no line.
    """
    try:
        yield
    except UserError as error:
        given = [setting.partition("=")[0].strip() for setting in settings]
        text = path.read_text(encoding="utf-8")
        for each in error.errors:
            key = key_of(each.args[0])
            mine = any(key == own or key.startswith((f"{own}.", f"{own}[")) for own in given)
            line = None if mine else line_of(text, key, scale)
            each.place = f" ({path}, line {line})" if line else ""
        raise


def key_of(message: str) -> str:
    """Return the key that a message is about, as grid.hurst[0]; "" where it names none."""
    found = NAMED.match(message)
    return found[1] if found else ""


def line_of(text: str, key: str, scale: str = "") -> int | None:
    """Return the number of the line where a key stands, or the table in which it is missing.

    scale : the one in force, whose tables come before the others. None where there is no such line.
    """
    wanted, of_scale = _parts(key), ["scales", scale]
    best = (0, False, 0)
    for path, number, header in _lines(text):
        within = bool(scale) and path[:2] == of_scale
        depth = _depth(path[2:] if within else path, wanted)
        best = max(best, (depth, within and not header, -number))
    return -best[2] if best[0] else None


def _lines(text: str) -> list[tuple[list[str], int, bool]]:
    """Return path and line of every header and key, and whether it is a header."""
    found: list[tuple[list[str], int, bool]] = []
    table: list[str] = []
    counts: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), 1):
        header, key = HEADER.match(line), KEY.match(line)
        if header:
            name = header[2]
            table = _parts(name)
            if header[1] == "[[":
                counts[name] = counts.get(name, -1) + 1
                table[-1] += f"[{counts[name]}]"
            found.append((table, number, True))
        elif key:
            found.append((table + _parts(key[1]), number, False))
    return found


def _parts(key: str) -> list[str]:
    return [part.strip("\"' ") for part in key.split(".")]


def _depth(path: list[str], wanted: list[str]) -> int:
    """Return how many parts of a key a line has; 0 where it is another's."""
    if len(path) > len(wanted):
        return 0
    for own, part in zip(path, wanted, strict=False):
        if own != part and own != INDEX.sub("", part):
            return 0
    return len(path)
