"""Detection of the kind of a file from its bytes: archive, text in some encoding, or neither."""

TEXT_BYTES = bytes(byte for byte in range(256) if byte >= 32 or byte in b"\t\n\r\f\v")
CLEAN_BYTES = 4096  # bytes at the start of a text that hold no control character
CONTROL_SHARE = 1e-3  # maximum share of control characters in the bytes of a text
ARCHIVE_SIGNATURES = {
    b"PK\x03\x04": "a zip archive",
    b"\x1f\x8b": "a gzip archive",
    b"BZh": "a bzip2 archive",
    b"\xfd7zXZ": "an xz archive",
    b"7z\xbc\xaf": "a 7z archive",
    b"Rar!": "a rar archive",
}


def archive_kind(data: bytes) -> str:
    """Return the kind of archive with these first bytes, in words; "" for other files."""
    if data[257:262] == b"ustar":
        return "a tar archive"
    return next((kind for begin, kind in ARCHIVE_SIGNATURES.items() if data.startswith(begin)), "")


def is_text(data: bytes) -> bool:
    """Return whether a file is text.

    The first CLEAN_BYTES bytes of a text hold no control character except whitespace, and
    the rest hold very few. The rest is examined because binary data may follow a text header.
    """
    if _utf_16_encoding(data):
        return True
    data = data.rstrip(b"\x1a\0")  # end-of-file marks of old systems
    controls = data.translate(None, TEXT_BYTES)
    return not data[:CLEAN_BYTES].translate(None, TEXT_BYTES) and len(
        controls
    ) <= CONTROL_SHARE * len(data)


def _utf_16_encoding(data: bytes) -> str:
    """Return the variant of UTF-16 of a text; "" for other encodings.

    Without a byte order mark, every other byte must be zero at the start and half of them overall.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    for first, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        high, low = data[first::2], data[1 - first :: 2]
        if len(high) > 8 and not any(high[:32]) and 2 * high.count(0) > len(high):
            return encoding if is_text(low) else ""
    return ""


def decoded(data: bytes) -> str:
    """Return the text of a file. Its encoding is inferred, as instruments seldom state it."""
    if encoding := _utf_16_encoding(data):
        text = data.decode(encoding, errors="replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("latin-1")  # decodes every byte, including the micro sign
    return text.replace("\u2212", "-")
