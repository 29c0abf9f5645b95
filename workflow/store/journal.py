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

from ..errors import UserError
from ..system import append_durably, refused

NAME = "journal"
FORMAT = "elastomer-friction journal 2"

Entry = dict[str, Any]


def encoded(entries: list[Entry]) -> bytes:
    """Return entries as lines of the journal: checksum, blank, JSON."""
    texts = [json.dumps(entry, separators=(",", ":")).encode() for entry in entries]
    return b"".join(b"%08x %s\n" % (zlib.crc32(text), text) for text in texts)


def append(folder: Path, entries: list[Entry]) -> None:
    """Append entries durably. Raises UserError when the disk refuses them."""
    append_durably(folder / NAME, encoded(entries))


def entry_in(line: bytes) -> Entry | None:
    """Return what a line tells, or None where a crash or a disk has spoilt it."""
    checksum, _, text = line.rstrip(b"\n").partition(b" ")
    if not line.endswith(b"\n") or checksum != b"%08x" % zlib.crc32(text):
        return None
    entry = json.loads(text)
    return entry if isinstance(entry, dict) else None


def entries(folder: Path, offset: int = 0) -> Iterator[tuple[Entry, int]]:
    """Yield (entry, offset of the line after it) of every sound line from ``offset`` on.

    Raises UserError where the disk refuses, and for a journal of another version of the format.
    """
    path = folder / NAME
    with refused(path, "cannot be read:"):
        try:
            file = path.open("rb")
        except FileNotFoundError:
            return
        with file:
            file.seek(offset)
            for line in file:
                offset += len(line)
                entry = entry_in(line)
                if entry is None:
                    continue
                if entry.get("format", FORMAT) != FORMAT:
                    raise UserError(
                        f"{path}: is of another version of the format ({entry['format']}, not "
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
