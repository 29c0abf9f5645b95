"""Measured moduli from a text table: G' and G'' over frequency, or G(t) after a sudden strain.

Columns are identified by names and units, else by order: frequency, G', G'', or time, G. A loss
factor tan delta may replace G'', and Young's moduli E are divided by 2 (1 + nu). The temperatures
of several sweeps come from a column, from the lines above each block, or from a list with one
temperature for each sweep in order.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..ground import UserError
from ..text_tables import TextTable, read_text_table
from .columns import Column, ColumnSpec, describe_columns, find_column, select_columns
from .side_by_side import below_one_another
from .sweeps import temperatures_of

FREQUENCIES = ("rad/s", "Hz")
MODULI = ("Pa", "kPa", "MPa", "GPa")
INCOMPRESSIBLE = 0.5  # Poisson's ratio of rubber
LOSS_FACTOR_NAME = r"tan|(loss|verlust)[ _-]*fa[ck]t|damping|d\u00e4mpf"
PRIME = r"['`\u2032\u2019\u00b4]"  # in various spellings of G'
DOUBLE_PRIME = rf"({PRIME}{{2}}|[\"\u2033\u201d])"
FREQUENCY = ColumnSpec(
    "a frequency", "frequency", r"freq|omega|\u03c9|^[fw\u03bd]$", "rad/s", "--frequency"
)
STORAGE_MODULUS = ColumnSpec(
    "a storage modulus G'",
    "pressure",
    rf"^(?!.*({LOSS_FACTOR_NAME})).*(stor|speicher|elastic|\b[GE]({PRIME}(?!{PRIME})|_?1\b|p\b|_?prime\b))",
    "Pa",
    "--modulus",
)
LOSS_MODULUS = ColumnSpec(
    "a loss modulus G''",
    "pressure",
    rf"^(?!.*({LOSS_FACTOR_NAME})).*(loss|verlust|viscous|\b[GE]({DOUBLE_PRIME}|_?2\b|pp\b|_?(double|2)_?prime\b))",
    "Pa",
    "--modulus",
)
LOSS_FACTOR = ColumnSpec("tan delta, for G''", "number", LOSS_FACTOR_NAME, "1")
RELAXATION_TIME = ColumnSpec("a time", "time", r"time|zeit|temps|tiempo|^t([\W_]|$)", "s")
RELAXATION_MODULUS = ColumnSpec(
    "a relaxation modulus", "pressure", r"modul|relax|^[GE]([\W_]|$)", "Pa", "--modulus"
)
OSCILLATORY = (FREQUENCY, LOSS_MODULUS, LOSS_FACTOR)
YOUNG_NAME = re.compile(
    rf"\bE({PRIME}|{DOUBLE_PRIME}|_|[12p]\b|\b)|young|tens|extens|bend|flex", re.I
)
SHEAR_NAME = re.compile(rf"\bG({PRIME}|{DOUBLE_PRIME}|_|[12p]\b|\b)|shear|torsion|parallel", re.I)
TENSILE_LOADING = re.compile(r"tension|tensile|cantilever|bending|compression", re.I)
# Names of moduli that are neither G' nor G''.
OTHER_MODULUS_NAME = re.compile(r"\*|\||complex|complian|dynamic", re.IGNORECASE)
STRAIN_NAME = r"strain|amplitude|dehnung|deform|verform|gamma|\u03b3"
MIN_MODULI_ROWS = 4
FREQUENCY_RATIO = 1.005  # frequencies closer than this count as equal
MODULUS_RATIO = 1.15  # limit of the ratio of moduli at one frequency and temperature
MAX_RELAXATION_SAMPLES = 400  # more samples of a relaxation test are averaged
MEANS_PER_DECADE = 25


class Moduli(NamedTuple):
    """Measured moduli at ascending frequencies, with a description of the columns."""

    omega: np.ndarray  # rad/s, shape (n,); for a relaxation test 1/t in 1/s
    values: np.ndarray  # G' + i G'' in Pa, shape (n,); for a relaxation test G(t), real
    description: tuple[str, ...]  # sentences
    temperatures: np.ndarray | None = None  # of each row, °C, shape (n,); None: one sweep

    @property
    def over_time(self) -> bool:
        """Return whether the moduli come from a relaxation test."""
        return not np.iscomplexobj(self.values)


def read_moduli(
    path: Path,
    frequency: str | None = None,
    modulus: str | None = None,
    columns: Sequence[int] | None = None,
    poisson: float = INCOMPRESSIBLE,
    temperatures: Sequence[float] = (),
    start: float | None = None,
) -> Moduli:
    """Return the moduli of a text file: frequency, G' and G'' or tan delta; or time and G(t).

    frequency, modulus : units that replace those of the file; rad/s and Pa if neither states them.
    columns : column numbers, from 0: three, or two for a relaxation test. poisson : Poisson's
    ratio, to convert Young's moduli. temperatures : temperature (°C) of each sweep in the order of
    the file, in place of those of the file. start : time (s) of a relaxation test before which
    samples are left out.

    Raises UserError for a file that cannot be read or does not determine the columns, for sweeps
    at unknown temperatures, and for unphysical values.
    """
    table = read_text_table("prony", path)
    if columns is None:
        _check_pairs(table)
        table = _with_sweeps_in_blocks(table, temperatures)
    selected = _moduli_columns(table, frequency, modulus, columns)
    if start is not None and len(selected) > 2:
        raise UserError(f"--from {start:g}: is a time of a relaxation test; {path} is none")
    temperature, description = temperatures_of(table, selected[0].values, temperatures)
    values, complete, left_out = _complete_rows(path, table, selected, temperature, start)
    description = [describe_columns(table, selected), *left_out, *description]
    omega, storage, *loss = values
    if loss and selected[2].spec.family == "number":
        loss = [loss[0] * storage]
        description.append("G'' = G' tan delta")
    measured = storage + 1j * loss[0] if loss else storage
    if _are_young_moduli(table, selected[1:]):
        measured = measured / (2.0 * (1.0 + poisson))
        description.append(f"Young's moduli E divided by 2 (1 + nu) = {2.0 * (1.0 + poisson):g}")
    elif not any(SHEAR_NAME.search(column.title.name) for column in selected[1:]):
        description.append("taken as shear moduli G, as nothing identifies them as Young's E")
    omega = omega if loss else 1.0 / omega
    order = np.argsort(omega, kind="stable")
    omega, measured = omega[order], measured[order]
    if temperature is not None:
        temperature = temperature[complete][order]
    levels = () if temperature is None else np.unique(temperature)
    row = np.flatnonzero(complete)[order]
    for at in [slice(None)] if temperature is None else [temperature == t for t in levels]:
        _check_single_sweep(path, table, selected, omega[at], measured[at], row[at])
    if not loss and temperature is None and omega.size > MAX_RELAXATION_SAMPLES:
        omega, measured = _decade_means(omega, measured)
        description.append(f"means over 1/{MEANS_PER_DECADE} of a decade of time: {omega.size}")
    return Moduli(omega, measured, tuple(description), temperature)


def _check_pairs(table: TextTable) -> None:
    """Raise UserError for several tests side by side whose pairs of columns are named alike."""
    names = [table.title(column).name for column in range(table.width)]
    pairs = table.width // 2
    if pairs > 1 and names[0] != names[1] and names == names[:2] * pairs:
        raise UserError(
            f"prony = {table.name!r}: holds {pairs} pairs of columns {names[0]!r}, {names[1]!r}, "
            "probably of several tests: give one of time and relaxation modulus with --columns "
            "0,1, or put sweeps below one another with --temperatures; J of a creep test is not a "
            "modulus"
        )


def _are_young_moduli(table: TextTable, moduli: Sequence[Column]) -> bool:
    """Return whether moduli are Young's moduli, by their names or else by the stated loading."""
    names = [column.title.name for column in moduli]
    if any(map(YOUNG_NAME.search, names)) or any(map(SHEAR_NAME.search, names)):
        return any(map(YOUNG_NAME.search, names))
    above = "\n".join(table.above)
    return bool(TENSILE_LOADING.search(above)) and not SHEAR_NAME.search(above)


def _is_relaxation_test(table: TextTable, columns: Sequence[int] | None) -> bool:
    """Return whether a table is a relaxation test: two columns, or time and no loss."""
    if columns is not None:
        return len(columns) == 2
    if len(table.numeric) == 2:
        return True
    lossy = any(find_column(table, spec) is not None for spec in OSCILLATORY)
    return not lossy and find_column(table, RELAXATION_TIME) is not None


def _with_sweeps_in_blocks(table: TextTable, temperatures: Sequence[float]) -> TextTable:
    """Return a table whose sweeps stand below one another even if they stand side by side."""
    titles = [table.title(column) for column in table.numeric]
    if not any(spec.fits_name(one) for spec in OSCILLATORY for one in titles):
        return below_one_another(table, RELAXATION_TIME, (RELAXATION_MODULUS,), temperatures)
    for loss in (LOSS_MODULUS, LOSS_FACTOR):
        table = below_one_another(table, FREQUENCY, (STORAGE_MODULUS, loss), temperatures)
    return table


def _moduli_columns(
    table: TextTable, frequency: str | None, modulus: str | None, columns: Sequence[int] | None
) -> tuple[Column, ...]:
    """Return the columns of frequency, G', and G'' or tan delta; or of time and G(t).

    A unit stated for only one of the moduli applies to both.
    """
    if _is_relaxation_test(table, columns):
        return select_columns(
            table, (RELAXATION_TIME, RELAXATION_MODULUS._replace(unit=modulus)), columns
        )
    wanted = [
        FREQUENCY._replace(unit=frequency),
        *(spec._replace(unit=modulus) for spec in (STORAGE_MODULUS, LOSS_MODULUS)),
    ]
    if columns is None:
        phase = (
            find_column(table, LOSS_MODULUS) is None and find_column(table, LOSS_FACTOR) is not None
        )
    else:
        phase = bool(re.search(LOSS_FACTOR_NAME, table.title(columns[2]).name, re.I))
    if phase:
        wanted[2] = LOSS_FACTOR
    selected = select_columns(table, wanted, columns)
    sources = {column.unit_source for column in selected[1:]}
    if not phase and sources == {"of the file", "assumed"}:
        unit = next(
            column.unit.text for column in selected[1:] if column.unit_source == "of the file"
        )
        wanted[1:] = [spec._replace(default=unit) for spec in wanted[1:]]
        selected = select_columns(table, wanted, columns)
    for column in selected[1:]:
        if OTHER_MODULUS_NAME.search(column.title.name):
            raise UserError(
                f"prony = {table.name!r}: column {column.number} {column.title.name!r} is not "
                f"{column.spec.meaning}: give G' = |G*| cos delta and G'' = |G*| sin delta"
            )
    return selected


def _complete_rows(
    path: Path,
    table: TextTable,
    columns: tuple[Column, ...],
    temperatures: np.ndarray | None,
    start: float | None,
) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Return the values of the complete rows, shape (columns, n), their row mask, and notes.

    For a relaxation test, rows with t <= 0 or t < start are left out and noted. Raises UserError
    for too few rows, for frequencies, G' and G(t) that are not positive, and for negative G''.
    """
    values = np.array([column.values for column in columns])
    complete = np.isfinite(values).all(axis=0) & (temperatures is None or np.isfinite(temperatures))
    notes = []
    if len(columns) == 2:
        early = complete & (values[0] <= 0.0 if start is None else values[0] < start)
        ends = "up to t = 0" if start is None else f"before {start:g} s"
        notes += [f"left out: {early.sum()} samples {ends}"] if early.any() else []
        complete &= ~early
    if complete.sum() < MIN_MODULI_ROWS:
        raise UserError(f"prony {path}: holds {complete.sum()} rows; a fit needs {MIN_MODULI_ROWS}")
    for column, column_values, positive in zip(columns, values, (True, True, False), strict=False):
        bad = complete & (column_values <= 0.0 if positive else column_values < 0.0)
        if np.any(bad):
            row = int(np.argmax(bad))
            raise UserError(
                f"prony {path}: line {table.lines[row]} holds {table.row(row)[column.number]} as "
                f"{column.spec.meaning}; must "
                + ("be greater than zero" if positive else "not be negative")
                + (_later_start(values[0, complete], bad[complete]) if len(columns) == 2 else "")
            )
    return values[:, complete], complete, notes


def _later_start(times: np.ndarray, bad: np.ndarray) -> str:
    """Return the remedy for moduli of a relaxation test that are not positive, as they ring."""
    later = times[times > times[bad].max()]
    if 2 * later.size > times.size:
        return (
            f": if it rings after the step, give --from {later.min():g}, the first time (s) later"
        )
    return ": leave out such samples if they are noise"


def _decade_means(omega: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return means over parts of each decade, so that late samples do not outweigh early ones."""
    part = np.floor(MEANS_PER_DECADE * np.log10(omega / omega[0]) + 1e-9)
    _, group, counts = np.unique(part, return_inverse=True, return_counts=True)
    sums = [np.bincount(group, weights) for weights in (np.log(omega), values)]
    return np.exp(sums[0] / counts), sums[1] / counts


def _check_single_sweep(
    path: Path,
    table: TextTable,
    columns: tuple[Column, ...],
    omega: np.ndarray,
    values: np.ndarray,
    rows: np.ndarray,
) -> None:
    """Raise UserError if one frequency, or one time, has several moduli. rows : of the table."""
    magnitude = np.abs(values)
    ratio = magnitude[1:] / magnitude[:-1]
    differs = np.maximum(ratio, 1.0 / ratio) > MODULUS_RATIO
    over_time = not np.iscomplexobj(values)
    near = 1.0 if over_time else FREQUENCY_RATIO  # late samples of a test are close to each other
    conflicts = np.flatnonzero((omega[1:] <= near * omega[:-1]) & differs)
    if conflicts.size:
        place = conflicts[0]
        low, high = sorted(magnitude[place : place + 2])
        subject = "one time has" if over_time else f"{omega[place]:.4g} rad/s has"
        used = [column.number for column in columns]
        raise UserError(
            f"prony {path}: {subject} several moduli, |G*| from {low:.3g} to {high:.3g} Pa"
            + _changed_condition(table, used, rows[place : place + 2])
        )


def _changed_condition(table: TextTable, used: Sequence[int], rows: np.ndarray) -> str:
    """Return which strain differs between two rows, or what else may, with the remedy."""
    for column in set(table.numeric) - set(used):
        title, ends = table.title(column), np.sort(table.values(column)[rows])
        if re.search(STRAIN_NAME, title.name, re.I) and ends[1] > MODULUS_RATIO * ends[0]:
            return (
                f", as column {column} {title.name!r} changes from {ends[0]:g} to {ends[1]:g} "
                f"{title.unit}: keep the rows of one strain"
            )
    return (
        ": keep the rows of one sweep, or give --temperatures, one for each sweep in order, to "
        "shift them to one curve"
    )
