"""Remarks above measured lines, such as pitch = 0.5 um."""

import math
import re

from ...ground import UserError
from ...text_tables import NUMERAL_TEXT, TextTable, is_numeral, split
from .raw_lines import KEY, LineFile, metres

REMARK = re.compile(r"([^:=;,\t]+)[:=;,\t](.*)")  # Width: 96 µm, also in two cells
QUANTITY_TEXT = re.compile(rf"({NUMERAL_TEXT})\s*(\S.*)?")
PITCH_REMARK = re.compile(
    r"(pitch|step|(sampl\w*|point|data|x|lateral)?[-_ ]*(spacing|step|interval|increment|pitch)"
    r"|d_?x|delta[-_ ]?x|x[-_ ]?(scale|resolution)|xy?[-_ ]?(calibration|justierung)"
    r"|(cell|pixel)[-_ ]?size)"
)
PER_SAMPLE = re.compile(r"\s*(/|per\s)\s*(pixel|px|point|pt|sample)s?$", re.IGNORECASE)
WIDTH_REMARK = re.compile(
    r"(width|breite|x[-_ ]?(size|range|length|extent)|scan[-_ ]?(size|width|length))"
)
HEIGHT_REMARK = re.compile(r"(height|höhe|y[-_ ]?(size|range|length|extent))")
UNIT_REMARK = re.compile(r"(value|z|height|data|y)?[-_ ]*(units?|einheit)")
MISSING_REMARK = re.compile(r"no[-_ ]?data([-_ ]?value)?|missing([-_ ]?value)?")
# Names whose values follow after blanks.
BARE_REMARK = re.compile(
    r"[;\s]*(cell_?size|no_?data_?value|mult|cz|wavelength)[\s:=]+(\S.*)", re.IGNORECASE
)
SCALE_REMARK = re.compile(
    r"mult|cz|wavelength|skalierung|(z|height)[-_ ]*(gain|sensitivity)"
    r"|(z|height|data|value|[hz]\w*)?s?[-_ ]*(conversion[-_ ]*)?"
    r"(scal(e|ing)|fa[ck]tor|multiplier|calibration|lsb|per[-_ ]*(count|lsb|digit|bit))"
    r"[-_ ]*(factor)?( ?[\[(].{0,20})?"  # z scale (nm)
)


def remarks_of(table: TextTable) -> dict[str, str]:
    """Return the values of remarks such as "Width: 96 µm", by their names in lower case.

    A line may hold several remarks. A line of two cells (or three, with a number and its unit) is
    a name and its value if the table has another number of columns.
    """
    remarks: dict[str, str] = {}
    for line in (line.lstrip("#%/! ") for line in table.above):
        cells = split(line, table.delimiter) if table.delimiter is not None else []
        few = len(cells) == 2 or (len(cells) == 3 and is_numeral(cells[1]))
        if few and len(cells) != table.width and all(cells):
            remarks.setdefault(cells[0].lower(), " ".join(cells[1:]))
        if bare := BARE_REMARK.fullmatch(line):
            remarks.setdefault(bare[1].lower(), bare[2].strip())
            continue
        for part in re.split(r"[,;\t]\s{0,8}(?=[^\W\d])", line.strip()):
            match = REMARK.fullmatch(part.lstrip("; \t").rstrip(" ;,\t"))
            if match and match[1].strip():
                remarks.setdefault(match[1].strip().lower(), match[2].strip('" \t'))
    return remarks


def quantity_of(text: str) -> tuple[float, str] | None:
    """Return number and unit of a text such as "0.5 um"; None for other texts."""
    match = QUANTITY_TEXT.fullmatch(text.strip())
    try:
        number = float(match[1].replace(",", ".")) if match else math.inf
    except ValueError:
        return None
    return (number, (match[2] or "").strip()) if match and math.isfinite(number) else None


def check_scale(file: LineFile, table: TextTable) -> None:
    """Raise UserError for a scale of heights other than 1, which is not supported."""
    for name, text in remarks_of(table).items():
        if SCALE_REMARK.fullmatch(name) and quantity_of(text) != (1.0, ""):
            raise UserError(
                f"{KEY} = {file.name!r}: states {name}: {text}, which is not read: multiply the "
                "heights and leave that line out"
            )


def stated_length(file: LineFile, table: TextTable, pattern: re.Pattern[str]) -> float | None:
    """Return the length (m) of the first remark whose name matches, or None."""
    for name, text in remarks_of(table).items():
        quantity = quantity_of(text)
        stem, _, suffix = name.rpartition("_")
        suffix = suffix if metres(suffix) is not None else ""
        bare = stem if suffix else re.sub(r"\s*[\[(].*", "", name)
        if quantity is None or not pattern.fullmatch(bare):
            continue
        unit = quantity[1] or suffix or "".join(re.findall(r"[\[(](.*?)[\])]", name))
        # A width without a unit may count samples.
        if not unit and file.units and pattern is PITCH_REMARK:
            unit = file.units[0]
        factor = metres(PER_SAMPLE.sub("", unit))
        if factor is not None and quantity[0] > 0.0:
            return quantity[0] * factor
    return None


def stated_code(table: TextTable) -> float | None:
    """Return the value that marks missing samples, from a remark such as NODATA_value, or None."""
    texts = (text for name, text in remarks_of(table).items() if MISSING_REMARK.fullmatch(name))
    return next((quantity[0] for quantity in map(quantity_of, texts) if quantity), None)


def stated_unit(table: TextTable) -> str:
    """Return the unit of heights from a remark such as "Value units: m"; "" without one."""
    units = [text for name, text in remarks_of(table).items() if UNIT_REMARK.fullmatch(name)]
    return next((unit for unit in units if metres(unit) is not None), "")
