"""Columns of numbers in a text file, beside study.toml."""

import math
import re
from pathlib import Path

import numpy as np

from workflow.errors import UserError

SEPARATORS = re.compile(r"[,;\s]+")


def read_columns(key: str, path: Path, names: tuple[str, ...]) -> np.ndarray:
    """Return the columns of a text file, shape (len(names), rows), all of them finite.

    Separators are commas, semicolons, tabs or spaces; empty lines, lines from "#" on and, before
    the first row of numbers, lines of words are passed over. Raises UserError, naming ``key`` and
    the line, for a file that cannot be read or holds anything else.
    """
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, ValueError) as error:  # ValueError: not UTF-8, or no name of a file
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {str(path)!r}: cannot be read: {reason}") from None
    rows: list[list[float]] = []
    for number, line in enumerate(lines, 1):
        entries = [entry for entry in SEPARATORS.split(line.partition("#")[0]) if entry]
        row = [_number(entry) for entry in entries]
        if not entries or (not rows and all(math.isnan(entry) for entry in row)):
            continue
        if len(row) != len(names) or not all(map(math.isfinite, row)):
            raise UserError(
                f"{key}: line {number} of {str(path)!r} reads {line.strip()!r:.40}: must hold "
                f"{len(names)} finite numbers, {' and '.join(names)}"
            )
        rows.append(row)
    if not rows:
        raise UserError(f"{key} = {str(path)!r}: holds no row of {len(names)} numbers")
    return np.array(rows).T


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
