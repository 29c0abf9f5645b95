"""The journal of a store: one line with a checksum per durable event.

Lines are only appended. A line damaged by a crash or by the disk is skipped, since the shards hold
the same information. An entry may state the format of the journal. A journal without this entry
was written by the first version; this version can read it.
"""

import json
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..ground import UserError, open_plain
from ..system import append_durably, refused

NAME = "journal"
MAX_LINE_BYTES = 2**26
JOURNAL_FORMAT = "elastomer-friction journal 2"

Entry = dict[str, Any]

REQUIRED_FIELDS: dict[str, dict[str, type]] = {  # kind of entry -> its further fields
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
    """Encode entries as JSON lines of the journal."""
    texts = (json.dumps(entry, separators=(",", ":")).encode() for entry in entries)
    return b"".join(line(text) for text in texts)


def line(text: bytes) -> bytes:
    """Return a line of the journal: the checksum of ``text``, a space and ``text``."""
    return b"%08x %s\n" % (zlib.crc32(text), text)


def append(folder: Path, entries: list[Entry]) -> None:
    """Append entries durably. Raises UserError when the disk refuses them."""
    append_durably(folder / NAME, encoded(entries))


def entry_in(line: bytes) -> Entry | None:
    """Return the entry of a line, or None for a damaged line."""
    checksum, _, text = line.rstrip(b"\n").partition(b" ")
    if not line.endswith(b"\n") or checksum != b"%08x" % zlib.crc32(text):
        return None
    try:
        entry = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return entry if isinstance(entry, dict) and _is_valid(entry) else None


def _is_valid(entry: Entry) -> bool:
    """Return whether an entry has the required fields of its kind, with the right types."""
    required = [{kind: str, **more} for kind, more in REQUIRED_FIELDS.items() if kind in entry]
    return all(
        isinstance(entry.get(name), type_) for fields in required for name, type_ in fields.items()
    )


def lines(folder: Path, offset: int = 0) -> Iterator[bytes]:
    """Yield the lines of a journal from ``offset`` on; yield nothing if the journal is missing.

    Raises UserError if the disk cannot read it.
    """
    path = folder / NAME
    with refused(path, "cannot be read:"):
        try:
            file = open_plain(path)
        except FileNotFoundError:
            return
        with file:
            file.seek(offset)
            while text := file.readline(MAX_LINE_BYTES):
                yield text


def entries(folder: Path, offset: int = 0) -> Iterator[tuple[Entry, int]]:
    """Yield (entry, offset of the next line) of every valid line from ``offset`` on.

    Raises UserError like ``lines``, and for a journal of another format.
    """
    for text in lines(folder, offset):
        offset += len(text)
        entry = entry_in(text)
        if entry is None:
            continue
        version = entry.get("format", JOURNAL_FORMAT)
        if version != JOURNAL_FORMAT:
            raise UserError(
                f"{folder / NAME}: has another format ({version}, not {JOURNAL_FORMAT}) and is not "
                "changed; choose another folder with --out"
            )
        yield entry, offset


def size(folder: Path) -> int:
    """Return the bytes of a journal, 0 if it is missing. Raises UserError like ``lines``."""
    path = folder / NAME
    with refused(path, "cannot be read:"):
        try:
            return path.stat().st_size
        except FileNotFoundError:
            return 0
