"""The journal of a store: one line per durable event, each line with its own checksum.

It is only ever appended to. A line that a crash or a disk has spoilt is skipped: what it told
is found again in the shards themselves.
"""

import json
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from workflow.system import append_durably

NAME = "journal"

Entry = dict[str, Any]


def lines_of(entries: list[Entry]) -> bytes:
    """Return entries as lines of the journal: checksum, blank, JSON."""
    texts = [json.dumps(entry, separators=(",", ":")).encode() for entry in entries]
    return b"".join(b"%08x %s\n" % (zlib.crc32(text), text) for text in texts)


def append(folder: Path, entries: list[Entry]) -> None:
    """Append entries durably. Raises UserError when the disk refuses them."""
    append_durably(folder / NAME, lines_of(entries))


def entries(folder: Path, offset: int = 0) -> Iterator[tuple[Entry, int]]:
    """Yield (entry, offset of the line after it) of every sound line from ``offset`` on."""
    try:
        with (folder / NAME).open("rb") as file:
            file.seek(offset)
            for line in file:
                offset += len(line)
                checksum, _, text = line.rstrip(b"\n").partition(b" ")
                if line.endswith(b"\n") and checksum == b"%08x" % zlib.crc32(text):
                    yield json.loads(text), offset
    except FileNotFoundError:
        return


def size(folder: Path) -> int:
    """Return the bytes of a journal, 0 where there is none."""
    path = folder / NAME
    return path.stat().st_size if path.is_file() else 0


def end_torn_line(folder: Path) -> None:
    """End a line that a crash cut short, so that the next one begins on its own."""
    path = folder / NAME
    if path.is_file() and path.read_bytes()[-1:] not in (b"", b"\n"):
        append_durably(path, b"\n")
