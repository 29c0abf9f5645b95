"""The journal of a store: one line per durable event, each line with its own checksum.

It is only ever appended to. A line that a crash or a disk has spoilt is skipped: what it told
is found again in the shards themselves. A line may tell the format of the journal; where none
does, it is that of the first version, whose lines this one reads.
"""

import json
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..ground import UserError, open_plain
from ..system import append_durably, refused

NAME = "journal"
LONGEST = 2**26  # bytes of a line: a longer one is spoilt
FORMAT = "elastomer-friction journal 2"

Entry = dict[str, Any]

TOLD: dict[str, dict[str, type]] = {  # kind of entry -> what is asked of it beside its name
    "format": {},
    "run": {},
    "part": {"keys": str},
    "maker": {"versions": str, "processor": str},
    "shard": {"bytes": int, "records": int, "chunks": list},
    "failed": {"why": str},
    "retry": {},
    "result": {"digest": str},
    "dropped": {},
}


def encoded(entries: list[Entry]) -> bytes:
    """Return entries as lines of the journal, in JSON."""
    return b"".join(line(json.dumps(each, separators=(",", ":")).encode()) for each in entries)


def line(text: bytes) -> bytes:
    """Return a line of the journal: the checksum of a text, a blank, the text."""
    return b"%08x %s\n" % (zlib.crc32(text), text)


def append(folder: Path, entries: list[Entry]) -> None:
    """Append entries durably. Raises UserError when the disk refuses them."""
    append_durably(folder / NAME, encoded(entries))


def entry_in(line: bytes) -> Entry | None:
    """Return what a line tells, or None where a crash or a disk has spoilt it."""
    checksum, _, text = line.rstrip(b"\n").partition(b" ")
    if not line.endswith(b"\n") or checksum != b"%08x" % zlib.crc32(text):
        return None
    try:
        entry = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return entry if isinstance(entry, dict) and _is_sound(entry) else None


def _is_sound(entry: Entry) -> bool:
    """Return whether an entry tells what is asked of its kind, in the right types."""
    asked = [{kind: str, **more} for kind, more in TOLD.items() if kind in entry]
    return all(isinstance(entry.get(name), of) for each in asked for name, of in each.items())


def lines(folder: Path, offset: int = 0) -> Iterator[bytes]:
    """Yield the lines of a journal from ``offset`` on, none where there is no journal.

    Raises UserError where the disk refuses.
    """
    path = folder / NAME
    with refused(path, "cannot be read:"):
        try:
            file = open_plain(path)
        except FileNotFoundError:
            return
        with file:
            file.seek(offset)
            while text := file.readline(LONGEST):
                yield text


def entries(folder: Path, offset: int = 0) -> Iterator[tuple[Entry, int]]:
    """Yield (entry, offset of the line after it) of every sound line from ``offset`` on.

    Raises UserError as ``lines``, and for a journal of another version of the format.
    """
    for text in lines(folder, offset):
        offset += len(text)
        entry = entry_in(text)
        if entry is None:
            continue
        if entry.get("format", FORMAT) != FORMAT:
            raise UserError(
                f"{folder / NAME}: is of another version of the format ({entry['format']}, not "
                f"{FORMAT}) and left as it is; choose another folder with --out"
            )
        yield entry, offset


def size(folder: Path) -> int:
    """Return the bytes of a journal, 0 where there is none. Raises UserError as ``entries``."""
    path = folder / NAME
    with refused(path, "cannot be read:"):
        try:
            return path.stat().st_size
        except FileNotFoundError:
            return 0
