"""The tables of a study.toml with its scale and the --set overrides applied."""

import copy
import json
import tomllib
from pathlib import Path
from typing import Any

from workflow.errors import UserError
from workflow.study import AXES


def load_tables(path: Path, scale: str | None, settings: list[str]) -> dict:
    """Return the tables of a TOML file; overrides are "table.key=value".

    Raises UserError for a file that is not TOML, an unknown scale and a broken override.
    """
    try:
        tables = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise UserError(f"{path}: cannot be read as TOML: {error}") from error
    scales = tables.pop("scales", {})
    if scale is not None:
        if scale not in as_table("scales", scales):
            known = ", ".join(scales) or "none"
            raise UserError(f"--scale {scale}: the study knows {known}")
        _merge(tables, scales[scale], f"scales.{scale}")
    for setting in settings:
        _merge(tables, _setting(setting), "--set")
    return tables


def _merge(tables: dict, extra: Any, where: str) -> None:
    for key, value in as_table(where, extra).items():
        if isinstance(value, dict) and isinstance(tables.get(key), dict) and key not in AXES:
            _merge(tables[key], value, f"{where}.{key}")
        else:
            tables[key] = copy.deepcopy(value)


def _setting(text: str) -> dict:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        key, separator, value = text.partition("=")
        if not separator:
            raise UserError(f"--set {text}: use table.key=value") from None
    try:  # a bare word is a string: --set numerics.scheme=exponential
        return tomllib.loads(f"{key}={json.dumps(value.strip())}")
    except tomllib.TOMLDecodeError:
        raise UserError(f"--set {text}: use table.key=value") from None


def as_table(key: str, value: Any) -> dict:
    """Return ``value`` if it is a table, or raise UserError naming the key."""
    if not isinstance(value, dict):
        raise UserError(f"{key} = {value!r}: must be a table")
    return value


def as_text(key: str, value: Any) -> str:
    """Return ``value`` if it is a string, or raise UserError naming the key."""
    if not isinstance(value, str):
        raise UserError(f"{key} = {value}: must be a string")
    return value


def check_keys(where: str, table: dict, known: tuple[str, ...]) -> None:
    """Raise UserError where a table holds a key that is not known; ``where`` goes before it."""
    for key in table:
        if key not in known:
            raise UserError(f"{where}{key}: unknown key; known are {', '.join(known)}")
