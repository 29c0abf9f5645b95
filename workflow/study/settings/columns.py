"""Columns of numbers in a text file, beside study.toml or given to a command."""

import re
from pathlib import Path

from ...errors import UserError
from .rows_of_numbers import BrokenRowError, Rows, read_rows


def read_columns(key: str, path: Path, names: tuple[str, ...]) -> Rows:
    """Return the columns of a text file that holds just these, all of their numbers finite.

    Raises UserError, naming ``key`` and the line, for a file that cannot be read or holds anything
    else.
    """
    return rows_of_file(key, path, tuple(range(len(names))), names, exact=True)


def rows_of_file(
    key: str, path: Path, columns: tuple[int, ...], names: tuple[str, ...], exact: bool = False
) -> Rows:
    """Return chosen columns of a text file; names : what they hold, for messages.

    Raises UserError as ``read_columns``.
    """
    places = "" if exact else f" in columns {list(columns)}"
    try:
        rows = read_rows(path.read_bytes(), columns, exact)
    except BrokenRowError as error:
        raise UserError(
            f"{key}: line {error.number} of {str(path)!r} reads {error.line!r:.40}: must hold "
            f"{len(names)} finite numbers{places}, {', '.join(names[:-1])} and {names[-1]}"
        ) from None
    except (OSError, ValueError) as error:  # ValueError: no name of a file
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {str(path)!r}: cannot be read: {reason}") from None
    if not rows.lines:
        raise UserError(f"{key} = {str(path)!r}: holds no row of {len(names)} numbers{places}")
    return rows


def named_unit(key: str, option: str, units: re.Pattern[str], header: str) -> str | None:
    """Return the one unit that the header of a file names; None where it names none.

    Raises UserError for two: ``option`` chooses.
    """
    found = list(dict.fromkeys(units.findall(header)))
    if len(found) > 1:
        raise UserError(f"{key}: names the units {' and '.join(found)}; choose by {option}")
    return found[0] if found else None
