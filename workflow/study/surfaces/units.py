"""Units of length, as they are named in files of instruments."""

import re
import unicodedata

METRES = {
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres"), 1e-2),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1e-3),
    **dict.fromkeys(("um", "micrometer", "micrometers", "micrometre", "micrometres"), 1e-6),
    **dict.fromkeys(("micron", "microns"), 1e-6),
    **dict.fromkeys(("nm", "nanometer", "nanometers", "nanometre", "nanometres"), 1e-9),
    **dict.fromkeys(("å", "angstrom", "angstroms", "ångström"), 1e-10),
    **dict.fromkeys(("pm", "picometer", "picometers", "picometre", "picometres"), 1e-12),
}
BETWEEN = re.compile(r"[^\w]+|_")


def metres(unit: str) -> float | None:
    """Return the metres of a unit of length, or None where the word is none: µm, UM, micron …."""
    # Both characters for micro, and letters with a ring, have one form each.
    word = unicodedata.normalize("NFKC", unit.strip()).replace("μ", "u")
    return METRES.get(word.lower()) if word != "M" else None


def units_in(text: str) -> list[str]:
    """Return the units of length among the words of a line of a header, in order."""
    return [word for word in BETWEEN.split(text) if word and metres(word) is not None]
