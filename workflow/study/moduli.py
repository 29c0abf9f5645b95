"""Read measured storage and loss moduli over frequency from a text table.

Columns are known by their names and units, else by their order: frequency, G', G''. A loss factor
tan delta serves in place of G'', and Young's moduli E are divided by 2 (1 + nu).
"""

import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..errors import UserError
from ..text_tables import Picked, TextTable, Wanted, picked, picked_by_name, read_text_table, told

FREQUENCIES = ("rad/s", "Hz")
MODULI = ("Pa", "kPa", "MPa", "GPa")
INCOMPRESSIBLE = 0.5  # Poisson's ratio of rubber
OF_PHASE = r"tan|loss[ _-]*fact|damping"
PRIME = r"['`\u2032\u2019\u00b4]"  # as people write G'
PRIMES = rf"({PRIME}{{2}}|[\"\u2033\u201d])"
OMEGA = Wanted(
    "a frequency", "frequency", r"freq|omega|\u03c9|^[fw\u03bd]$", "rad/s", "--frequency"
)
STORAGE = Wanted(
    "a storage modulus G'",
    "pressure",
    rf"^(?!.*({OF_PHASE})).*(stor|elastic|\b[GE]({PRIME}(?!{PRIME})|_?1\b|p\b|_?prime\b))",
    "Pa",
    "--modulus",
)
LOSS = Wanted(
    "a loss modulus G''",
    "pressure",
    rf"^(?!.*({OF_PHASE})).*(loss|viscous|\b[GE]({PRIMES}|_?2\b|pp\b|_?(double|2)_?prime\b))",
    "Pa",
    "--modulus",
)
PHASE = Wanted("tan delta, for G''", "number", OF_PHASE, "1")
TEMPERATURE = Wanted("a temperature", "temperature", r"temp|^T[s]?$", "°C")
OF_YOUNG = re.compile(rf"\bE({PRIME}|{PRIMES}|_|[12p]\b|\b)|young|tens|extens|bend|flex", re.I)
OTHER = re.compile(r"\*|\||complex|complian|dynamic", re.IGNORECASE)  # no G', and no G''
LEAST = 4  # frequencies
SAME = 1.005  # ratio of frequencies that are one
SEVERAL = 1.15  # ratio of moduli at one frequency that are not one material at one temperature
APART = 2.0  # K


class Moduli(NamedTuple):
    """Measured moduli, frequencies ascending, and what the file was read as."""

    omega: np.ndarray  # rad/s, shape (n,)
    values: np.ndarray  # G' + i G'' in Pa, shape (n,)
    told: tuple[str, ...]  # in sentences


def read_moduli(
    path: Path,
    frequency: str | None = None,
    modulus: str | None = None,
    columns: Sequence[int] | None = None,
    poisson: float = INCOMPRESSIBLE,
) -> Moduli:
    """Return the moduli of a text file with the columns frequency, G' and G'' or tan delta.

    frequency, modulus : units, which go before those that the file states; rad/s and Pa where
    neither does. columns : numbers, from 0, of the three. poisson : ratio for Young's moduli.

    Raises UserError for a file that cannot be read or does not say which columns are meant, for
    relaxation tests and sweeps at several temperatures, and for values that no material has.
    """
    table = read_text_table("prony", path)
    if columns is None and len(table.numeric) == 2:
        raise UserError(
            f"prony {path}: two columns are a relaxation test, a modulus over time, which is not "
            "read: give moduli G' and G'' over frequency"
        )
    found = _columns(table, frequency, modulus, columns)
    omega, storage, loss = _complete(path, table, found)
    said = [told(table, found)]
    if found[2].wanted.family == "number":
        loss = loss * storage
        said.append("G'' = G' tan delta")
    if any(OF_YOUNG.search(one.title.name) for one in found[1:]):
        storage, loss = storage / (2.0 * (1.0 + poisson)), loss / (2.0 * (1.0 + poisson))
        said.append(f"Young's moduli E divided by 2 (1 + nu) = {2.0 * (1.0 + poisson):g}")
    order = np.argsort(omega, kind="stable")
    omega, values = omega[order], (storage + 1j * loss)[order]
    _one_temperature(path, table, omega, values)
    return Moduli(omega, values, tuple(said))


def _columns(
    table: TextTable, frequency: str | None, modulus: str | None, columns: Sequence[int] | None
) -> tuple[Picked, ...]:
    """Return the columns frequency, G' and G'' or tan delta; one states the unit of both moduli."""
    wanted = [OMEGA._replace(unit=frequency), *(w._replace(unit=modulus) for w in (STORAGE, LOSS))]
    if columns is None:
        phase = picked_by_name(table, LOSS) is None and picked_by_name(table, PHASE) is not None
    else:
        phase = columns[2] < table.width and bool(
            re.search(OF_PHASE, table.title(columns[2]).name, re.I)
        )
    if phase:
        wanted[2] = PHASE
    found = picked(table, wanted, columns)
    if not phase and {found[1].whose, found[2].whose} == {"of the file", "assumed"}:
        unit = next(one.unit.text for one in found[1:] if one.whose == "of the file")
        wanted[1:] = [one._replace(default=unit) for one in wanted[1:]]
        found = picked(table, wanted, columns)
    for one in found[1:]:
        if OTHER.search(one.title.name):
            raise UserError(
                f"prony = {table.name!r}: column {one.number} {one.title.name!r} is not "
                f"{one.wanted.what}: give G' = |G*| cos delta and G'' = |G*| sin delta"
            )
    return found


def _complete(path: Path, table: TextTable, found: tuple[Picked, ...]) -> np.ndarray:
    """Return the columns without rows in which a value is missing, shape (3, n)."""
    values = np.array([one.values for one in found])
    there = np.isfinite(values).all(axis=0)
    if there.sum() < LEAST:
        raise UserError(f"prony {path}: holds {there.sum()} rows; a fit needs {LEAST}")
    for one, own, least in zip(found, values, (True, True, False), strict=True):
        bad = there & (own <= 0.0 if least else own < 0.0)
        if np.any(bad):
            row = int(np.argmax(bad))
            raise UserError(
                f"prony {path}: line {table.lines[row]} holds {table.rows[row][one.number]} as "
                f"{one.wanted.what}; must "
                + ("be greater than zero" if least else "not be negative")
            )
    return values[:, there]


def _one_temperature(path: Path, table: TextTable, omega: np.ndarray, values: np.ndarray) -> None:
    """Raise UserError for a table of several temperatures: one frequency has several moduli."""
    way = "shift the sweeps to one temperature first, and give the shifted frequencies"
    named = picked_by_name(table, TEMPERATURE)
    if named is not None and np.nanmax(named.values) - np.nanmin(named.values) > APART:
        low, high = np.nanmin(named.values) - 273.15, np.nanmax(named.values) - 273.15
        raise UserError(
            f"prony {path}: holds several temperatures, column {named.number} "
            f"{named.title.name} from {low:g} to {high:g} °C: {way}"
        )
    starts = np.flatnonzero(np.append(True, omega[1:] > SAME * omega[:-1]))
    for start, end in pairwise([*starts.tolist(), omega.size]):
        size = np.abs(values[start:end])
        if size.max() > SEVERAL * size.min():
            raise UserError(
                f"prony {path}: {omega[start]:.4g} rad/s has several moduli, |G*| from "
                f"{size.min():.3g} to {size.max():.3g} Pa, as at several temperatures: {way}"
            )
