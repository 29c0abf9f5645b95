"""Detection of the kind of a file from its bytes: text in some encoding, or other content."""

TEXT_BYTES = bytes(byte for byte in range(256) if byte >= 32 or byte in b"\t\n\r\f\v")
CLEAN_BYTES = 4096  # bytes at the start of a text that hold no control character
CONTROL_SHARE = 1e-3  # maximum share of control characters in the bytes of a text
UNPACK = "unpack it and name one file"
EXPORT = "export its heights as text"
EXPORT_TABLE = "export the table as text"
MESH = "a mesh: export a height map or points x y z"
SAVE_AS_TEXT = "save the sheet as CSV"
PICTURE = f"a picture, which has no heights in metres: {EXPORT}"
FOREIGN_SIGNATURES = {  # first bytes, bytes that must follow, content and remedy
    (b"PK\x03\x04", b"xl/"): f"an Excel workbook: {SAVE_AS_TEXT}",
    (b"PK\x03\x04", b"[Content_Types].xml"): f"an Excel workbook: {SAVE_AS_TEXT}",
    (b"PK\x03\x04", b"opendocument.spreadsheet"): f"a spreadsheet: {SAVE_AS_TEXT}",
    (b"PK\x03\x04", b""): f"a zip archive: {UNPACK}",
    (b"\xd0\xcf\x11\xe0", b""): "an Excel 97 workbook or another OLE file: save it as text",
    (b"\x1f\x8b", b""): f"a gzip archive: {UNPACK}",
    (b"BZh", b""): f"a bzip2 archive: {UNPACK}",
    (b"\xfd7zXZ", b""): f"an xz archive: {UNPACK}",
    (b"7z\xbc\xaf", b""): f"a 7z archive: {UNPACK}",
    (b"Rar!", b""): f"a rar archive: {UNPACK}",
    (b"\x89PNG", b""): PICTURE,
    (b"\xff\xd8\xff", b""): PICTURE,
    (b"GIF8", b""): PICTURE,
    (b"ply", b"element face"): MESH,
    (b"solid", b"facet"): MESH,
    (b"#VRML", b""): MESH,
    (b"OFF\n", b""): MESH,
    (b"DSCOMPRESSED", b""): "a compressed Surf file: save it uncompressed",
    (b"Gwyddion Simple Field", b""): f"a field of Gwyddion: {EXPORT}",
    (b"{", b'":'): f"JSON: {EXPORT_TABLE}",
    (b"[", b'":'): f"JSON: {EXPORT_TABLE}",
    (b"<?xml", b""): f"XML: {EXPORT_TABLE}",
    (b"<!DOCTYPE", b""): f"a web page: {EXPORT_TABLE}",
    (b"<html", b""): f"a web page: {EXPORT_TABLE}",
    (b"%PDF-", b""): f"a PDF: {EXPORT_TABLE}",
}
MAX_SIGNATURE_BYTES = 4096  # that are searched


def foreign_content(data: bytes) -> str:
    """Return the content of a file that is not read, with a remedy; "" for other files."""
    if data[257:262] == b"ustar":
        return f"a tar archive: {UNPACK}"
    start = data[:MAX_SIGNATURE_BYTES]
    kinds = FOREIGN_SIGNATURES.items()
    return next((kind for (a, b), kind in kinds if start.startswith(a) and b in start), "")


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
