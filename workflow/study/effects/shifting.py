"""Shift of relaxation times with the temperature: keys, tables in files, and their checks."""

import math
import re
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np

from ....kernels import ZERO_CELSIUS, Arrhenius, ShiftLaw, ShiftTable, Wlf
from ...ground import UserError
from ...text_tables import read_text_table
from ..columns import ColumnSpec, describe_columns, select_columns
from ..settings import (
    FILE_NAME,
    NUMBER,
    OPTIONAL,
    Key,
    inline_table,
    number,
    pair,
    positive,
    two_numbers,
)

MAX_SHIFT_DECADES = 30.0
KELVIN_SUSPICION = 230.0  # degrees above the reference: the value is probably in K
SHIFT_HEADER_ADVICE = 'a header "temperature [°C], log a_T"'
TEMPERATURE_COLUMN = ColumnSpec(
    "a temperature", "temperature", r"temp|^T([\W_]|$)", "°C", SHIFT_HEADER_ADVICE
)
DECADES = ColumnSpec("log10 a_T", "number", r"a_?T|shift|log", "1", SHIFT_HEADER_ADVICE)


def shift_refusal(law: ShiftLaw, temperature: float) -> str:
    """Return the reason why a temperature (°C) is out of the range of a law, or ""."""
    low, high = law.limits
    if isinstance(law, ShiftTable):
        hint = "; give it in °C, not K" if temperature > high + KELVIN_SUSPICION else ""
        inside = low <= temperature <= high
        return (
            "" if inside else f"must lie within the table of shifts, {low:g} to {high:g} °C{hint}"
        )
    if isinstance(law, Wlf) and temperature <= low:
        return f"must be above reference - c2 = {low:g}, the pole of the WLF shift"
    if min(temperature, law.reference) <= low:
        return f"it and the reference {law.reference:g} must be above {low:g}"
    above = temperature - law.reference
    if above <= KELVIN_SUSPICION:
        return ""
    return f"is {above:g} degrees above the reference {law.reference:g}; give both in °C, not K"


def read_shift_table(key: str, path: Path) -> ShiftTable:
    """Return the shifts of a text table with columns temperature and log10 a_T, ln a_T or a_T.

    A column without a name, or with one such as "shift", holds log10 a_T.

    Raises UserError, which begins with ``key``.
    """
    table = read_text_table(key, path, path.name)
    columns = select_columns(table, (TEMPERATURE_COLUMN, DECADES), None, SHIFT_HEADER_ADVICE)
    temperature, shift = columns
    values, name, read_as = shift.values, shift.title.name, ""
    if re.match(r"-|1\s*/", name):
        raise table.refused(
            f"the column {name!r} holds shifts of frequencies: change their sign, and give "
            f"{SHIFT_HEADER_ADVICE}"
        )
    if re.match(r"ln", name, re.IGNORECASE):
        values, read_as = values / math.log(10.0), "; these are ln a_T"
    elif re.search(r"^(?!.*(log|lg)).*(a_?T|factor)", name, re.IGNORECASE):
        if np.any(values <= 0.0):
            raise table.refused(f"a_T must be greater than zero; give {SHIFT_HEADER_ADVICE}")
        values, read_as = np.log10(values), "; these are a_T itself"
    rows = np.stack([temperature.values - ZERO_CELSIUS, values], axis=1).tolist()
    description = describe_columns(table, columns) + read_as
    return _shift_table(key, rows)._replace(description=description)


def _shift_table(key: str, value: object) -> ShiftTable:
    """Return the table of rows [temperature (°C), log10 a_T]. Raises UserError."""
    if not isinstance(value, list) or len(value) < 2:
        raise UserError(
            f"{key} = {value!r:.60}: must be a list of at least two rows [°C, log10 a_T]"
        )
    words = "[temperature in °C, log10 a_T]"
    rows = sorted(
        two_numbers(f"{key}[{i}]", row, words, number, number) for i, row in enumerate(value)
    )
    repeated = [row[0] for row, following in pairwise(rows) if row[0] == following[0]]
    if repeated:
        raise UserError(f"{key}: must not contain the temperature {repeated[0]:g} twice")
    return ShiftTable(tuple(rows))


def check_shift(where: str, laws: dict[str, ShiftLaw | None], value: float | None) -> None:
    """Raise UserError for an inconsistent choice of laws or a temperature out of range.

    where : name of the table, for messages. laws : key -> law or None. value : temperature, °C.
    """
    chosen = {key: law for key, law in laws.items() if law is not None}
    if len(chosen) > 1:
        first, second, *_ = chosen
        raise UserError(f"{where}.{second}: give either it or {where}.{first}")
    if not chosen and value is None:
        return
    if not chosen:
        others = " or ".join(list(laws)[1:])
        raise UserError(f"{where}.wlf: missing; {where}.temperature needs it, or {others}")
    ((key, law),) = chosen.items()
    if value is None:
        raise UserError(f"{where}.temperature: missing; {where}.{key} needs it")
    assert law is not None
    reason = shift_refusal(law, value)
    if not reason and not abs(law.decades(value)) <= MAX_SHIFT_DECADES:
        reason = (
            f"shifts times by {law.decades(value):.3g} decades; at most {MAX_SHIFT_DECADES:g} are "
            "supported"
        )
    if reason:
        raise UserError(f"{where}.temperature = {value!r}: {reason}")


REFERENCE = Key(
    number,
    "The temperature to which the given relaxation times refer.",
    "Doubling degrees Celsius has no meaning.",
    "°C",
)
WLF = {
    "c1": Key(
        positive,
        "The first constant of the shift, in decades.",
        "Doubled, times shift by twice as many decades.",
    ),
    "c2": Key(
        positive,
        "The second constant of the shift.",
        "Doubled, times depend half as strongly on the temperature near the reference.",
        "K",
    ),
    "reference": REFERENCE,
}
ARRHENIUS = {
    "activation_energy": Key(
        positive,
        "The activation energy E_a of relaxation.",
        "Doubled, times shift by twice as many decades.",
        "J/mol",
    ),
    "reference": REFERENCE,
}
SHIFTS = {
    "wlf": OPTIONAL(
        partial(inline_table, keys=WLF, make=Wlf),
        "The shift of Williams, Landel and Ferry, log₁₀ a_T = −c1 (T − reference)/(c2 + T − "
        "reference); a_T multiplies all relaxation times. The law of Vogel, Fulcher and Tammann "
        "has c2 = reference − T₀ and c1 = B/(c2 ln 10).",
    ),
    "arrhenius": OPTIONAL(
        partial(inline_table, keys=ARRHENIUS, make=Arrhenius),
        "The shift of Arrhenius, ln a_T = E_a/R (1/T − 1/reference) with temperatures in K, in "
        "place of `wlf`.",
    ),
    "shifts": OPTIONAL(
        _shift_table,
        "A measured table of the shift, with T in °C, in place of `wlf`, interpolated linearly "
        "and not extrapolated.",
        values="a list of at least two rows `[T, log₁₀ a_T]`",
        schema={"type": "array", "minItems": 2, "items": pair(NUMBER, NUMBER)},
    ),
    "shifts_file": FILE_NAME(
        "A text file beside `study.toml` with these columns, in place of `shifts`; a column may "
        "also be named a_T or ln a_T.",
        default="",
    ),
}
