"""Read measured moduli from a text table: G' and G'' over frequency, or G(t) after a sudden strain.

Columns are known by their names and units, else by their order: frequency, G', G'', or time, G. A
loss factor tan delta serves in place of G'', and Young's moduli E are divided by 2 (1 + nu).
Sweeps at several temperatures are told apart by a column of them, by the lines above each block,
or by a list of temperatures, one for each sweep in order.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..ground import UserError
from ..text_tables import (
    Column,
    ColumnSpec,
    TextTable,
    describe_columns,
    find_column,
    read_text_table,
    select_columns,
)
from .sweeps import temperatures_of

FREQUENCIES = ("rad/s", "Hz")
MODULI = ("Pa", "kPa", "MPa", "GPa")
INCOMPRESSIBLE = 0.5  # Poisson's ratio of rubber
OF_PHASE = r"tan|loss[ _-]*fact|damping"
PRIME = r"['`\u2032\u2019\u00b4]"  # as people write G'
PRIMES = rf"({PRIME}{{2}}|[\"\u2033\u201d])"
OMEGA = ColumnSpec(
    "a frequency", "frequency", r"freq|omega|\u03c9|^[fw\u03bd]$", "rad/s", "--frequency"
)
STORAGE = ColumnSpec(
    "a storage modulus G'",
    "pressure",
    rf"^(?!.*({OF_PHASE})).*(stor|speicher|elastic|\b[GE]({PRIME}(?!{PRIME})|_?1\b|p\b|_?prime\b))",
    "Pa",
    "--modulus",
)
LOSS = ColumnSpec(
    "a loss modulus G''",
    "pressure",
    rf"^(?!.*({OF_PHASE})).*(loss|verlust|viscous|\b[GE]({PRIMES}|_?2\b|pp\b|_?(double|2)_?prime\b))",
    "Pa",
    "--modulus",
)
PHASE = ColumnSpec("tan delta, for G''", "number", OF_PHASE, "1")
TIME = ColumnSpec("a time", "time", r"time|^t([\W_]|$)", "s")
RELAXED = ColumnSpec(
    "a relaxation modulus", "pressure", r"modul|relax|^[GE]([\W_]|$)", "Pa", "--modulus"
)
OF_YOUNG = re.compile(rf"\bE({PRIME}|{PRIMES}|_|[12p]\b|\b)|young|tens|extens|bend|flex", re.I)
OF_SHEAR = re.compile(rf"\bG({PRIME}|{PRIMES}|_|[12p]\b|\b)|shear|torsion|parallel", re.I)
OF_LOADING = re.compile(r"tension|tensile|cantilever|bending|compression", re.I)
OTHER = re.compile(r"\*|\||complex|complian|dynamic", re.IGNORECASE)  # no G', and no G''
LEAST = 4  # frequencies
SAME = 1.005  # ratio of frequencies that are one
SEVERAL = 1.15  # ratio of moduli at one frequency that are not one material at one temperature
MANY = 400  # samples of a relaxation test, of which more are averaged
PER_DECADE = 25


class Moduli(NamedTuple):
    """Measured moduli, frequencies ascending, and what the file was read as."""

    omega: np.ndarray  # rad/s, shape (n,); of a relaxation test 1/t in 1/s
    values: np.ndarray  # G' + i G'' in Pa, shape (n,); of a relaxation test G(t), real
    description: tuple[str, ...]  # in sentences
    temperatures: np.ndarray | None = None  # °C of each sweep, shape (n,); None: there is one

    @property
    def over_time(self) -> bool:
        """Return whether they are those of a relaxation test."""
        return not np.iscomplexobj(self.values)


def read_moduli(
    path: Path,
    frequency: str | None = None,
    modulus: str | None = None,
    columns: Sequence[int] | None = None,
    poisson: float = INCOMPRESSIBLE,
    temperatures: Sequence[float] = (),
) -> Moduli:
    """Return the moduli of a text file: frequency, G' and G'' or tan delta; or time and G(t).

    frequency, modulus : units, which go before those that the file states; rad/s and Pa where
    neither does. columns : numbers, from 0, of the three, or of the two of a relaxation test.
    poisson : ratio for Young's moduli. temperatures : °C, of each sweep in the order of the file,
    which go before what the file says.

    Raises UserError for a file that cannot be read or does not say which columns are meant, for
    sweeps at temperatures that nobody tells, and for values that no material has.
    """
    table = read_text_table("prony", path)
    found = _columns(table, frequency, modulus, columns)
    each, said = temperatures_of(table, found[0].values, temperatures)
    values, there, left_out = _complete(path, table, found, each)
    said = [describe_columns(table, found), *left_out, *said]
    omega, storage, *loss = values
    if loss and found[2].spec.family == "number":
        loss = [loss[0] * storage]
        said.append("G'' = G' tan delta")
    measured = storage + 1j * loss[0] if loss else storage
    if _of_young(table, found[1:]):
        measured = measured / (2.0 * (1.0 + poisson))
        said.append(f"Young's moduli E divided by 2 (1 + nu) = {2.0 * (1.0 + poisson):g}")
    elif not any(OF_SHEAR.search(one.title.name) for one in found[1:]):
        said.append("taken as shear moduli G, as nothing says that they are Young's E")
    omega = omega if loss else 1.0 / omega
    order = np.argsort(omega, kind="stable")
    omega, measured = omega[order], measured[order]
    if each is not None:
        each = each[there][order]
    for own in [slice(None)] if each is None else [each == t for t in np.unique(each)]:
        _one_temperature(path, omega[own], measured[own])
    if not loss and each is None and omega.size > MANY:
        omega, measured = _averaged(omega, measured)
        said.append(f"means over 1/{PER_DECADE} of a decade of time: {omega.size}")
    return Moduli(omega, measured, tuple(said), each)


def _of_young(table: TextTable, moduli: Sequence[Column]) -> bool:
    """Return whether moduli are Young's: by their names, else by the way of loading above them."""
    names = [one.title.name for one in moduli]
    if any(map(OF_YOUNG.search, names)) or any(map(OF_SHEAR.search, names)):
        return any(map(OF_YOUNG.search, names))
    above = "\n".join(table.above)
    return bool(OF_LOADING.search(above)) and not OF_SHEAR.search(above)


def _over_time(table: TextTable, columns: Sequence[int] | None) -> bool:
    """Return whether a table is a relaxation test: two columns, or a time and no loss."""
    if columns is not None:
        return len(columns) == 2
    if len(table.numeric) == 2:
        return True
    lossy = any(find_column(table, one) is not None for one in (LOSS, PHASE, OMEGA))
    return not lossy and find_column(table, TIME) is not None


def _columns(
    table: TextTable, frequency: str | None, modulus: str | None, columns: Sequence[int] | None
) -> tuple[Column, ...]:
    """Return the columns frequency, G' and G'' or tan delta; one states the unit of both moduli.

    Of a relaxation test they are time and G(t).
    """
    if _over_time(table, columns):
        return select_columns(table, (TIME, RELAXED._replace(unit=modulus)), columns)
    wanted = [OMEGA._replace(unit=frequency), *(w._replace(unit=modulus) for w in (STORAGE, LOSS))]
    if columns is None:
        phase = find_column(table, LOSS) is None and find_column(table, PHASE) is not None
    else:
        phase = columns[2] < table.width and bool(
            re.search(OF_PHASE, table.title(columns[2]).name, re.I)
        )
    if phase:
        wanted[2] = PHASE
    found = select_columns(table, wanted, columns)
    if not phase and {found[1].unit_source, found[2].unit_source} == {"of the file", "assumed"}:
        unit = next(one.unit.text for one in found[1:] if one.unit_source == "of the file")
        wanted[1:] = [one._replace(default=unit) for one in wanted[1:]]
        found = select_columns(table, wanted, columns)
    for one in found[1:]:
        if OTHER.search(one.title.name):
            raise UserError(
                f"prony = {table.name!r}: column {one.number} {one.title.name!r} is not "
                f"{one.spec.meaning}: give G' = |G*| cos delta and G'' = |G*| sin delta"
            )
    return found


def _complete(
    path: Path, table: TextTable, found: tuple[Column, ...], each: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Return the columns without rows in which a value is missing, shape (columns, n).

    Then which rows these are, and what was left out in words: those up to a sudden strain are, too.
    """
    values = np.array([one.values for one in found])
    there = np.isfinite(values).all(axis=0) & (each is None or np.isfinite(each))
    said = []
    if len(found) == 2 and np.any(values[0, there] <= 0.0):
        early = there & (values[0] <= 0.0)
        said.append(f"left out: {early.sum()} samples up to t = 0")
        there &= ~early
    if there.sum() < LEAST:
        raise UserError(f"prony {path}: holds {there.sum()} rows; a fit needs {LEAST}")
    for one, own, least in zip(found, values, (True, True, False), strict=False):
        bad = there & (own <= 0.0 if least else own < 0.0)
        if np.any(bad):
            row = int(np.argmax(bad))
            raise UserError(
                f"prony {path}: line {table.lines[row]} holds {table.rows[row][one.number]} as "
                f"{one.spec.meaning}; must "
                + ("be greater than zero" if least else "not be negative")
            )
    return values[:, there], there, said


def _averaged(omega: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return means over parts of a decade, so that late samples do not outnumber early ones."""
    part = np.floor(PER_DECADE * np.log10(omega / omega[0]) + 1e-9)
    _, own, counts = np.unique(part, return_inverse=True, return_counts=True)
    sums = [np.bincount(own, weights) for weights in (np.log(omega), values)]
    return np.exp(sums[0] / counts), sums[1] / counts


def _one_temperature(path: Path, omega: np.ndarray, values: np.ndarray) -> None:
    """Raise UserError where one frequency has several moduli, as at several temperatures."""
    size = np.abs(values)
    ratio = size[1:] / size[:-1]
    apart = np.maximum(ratio, 1.0 / ratio) > SEVERAL
    found = np.flatnonzero((omega[1:] <= SAME * omega[:-1]) & apart)
    if found.size:
        place = found[0]
        low, high = sorted(size[place : place + 2])
        one = f"{omega[place]:.4g} rad/s has" if np.iscomplexobj(values) else "one time has"
        raise UserError(
            f"prony {path}: {one} several moduli, |G*| from {low:.3g} to {high:.3g} Pa, as at "
            "several temperatures: give --temperatures, one for each sweep in order, to shift "
            "them to one curve"
        )
