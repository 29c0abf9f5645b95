"""Read study.toml: find it, apply the scale and --set, build the Study, and locate errors."""

import contextlib
import copy
import json
import re
import tomllib
from bisect import bisect_left
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..ground import UserError, did_you_mean, read_plain
from .axes import COMMON_AXES
from .measured import read_measured
from .settings import as_table
from .study import AnyStudy, Study, read_grid_study

MAX_STUDY_BYTES = 2**24
BARE_LIST = re.compile(r"=\s*[-+.\d][-+.\deE_]*\s*,")  # a list without brackets


def load_tables(path: Path, scale: str | None, settings: list[str]) -> tuple[dict, dict]:
    """Return the tables of a file with scale and overrides "table.key=value", and other scales.

    Raises UserError for a file that is not TOML, an unknown scale and an invalid override.
    """
    try:
        tables = tomllib.loads(read_plain(path, MAX_STUDY_BYTES).decode())
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        place = re.search(r"at line (\d+)", str(error))
        lines = path.read_text(encoding="utf-8").splitlines() if place else []
        bare = place and BARE_LIST.search(lines[int(place[1]) - 1])
        hint = "; write a list as [0.3, 0.5]" if bare else ""
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{path}: cannot be read as TOML: {reason}{hint}") from error
    scales = tables.pop("scales", {})
    if scale is not None:
        if scale not in as_table("scales", scales):
            known = ", ".join(scales) or "none"
            near = did_you_mean(scale, scales)
            raise UserError(f"--scale {scale}: must be a scale of the study: {known}{near}")
        _merge(tables, scales.pop(scale), f"scales.{scale}")
    for setting in settings:
        _merge(tables, _setting(setting), "--set")
    return tables, as_table("scales", scales)


def _merge(tables: dict, extra: Any, where: str) -> None:
    for key, value in as_table(where, extra).items():
        if isinstance(value, dict) and isinstance(tables.get(key), dict) and key not in COMMON_AXES:
            _merge(tables[key], value, f"{where}.{key}")
        else:
            tables[key] = copy.deepcopy(value)


def _setting(text: str) -> dict:
    key, separator, value = text.partition("=")
    # The second form accepts a string without quotes: --set numerics.scheme=exponential
    for toml in (text, f"{key}{separator}{json.dumps(value.strip())}"):
        with contextlib.suppress(tomllib.TOMLDecodeError):
            return tomllib.loads(toml)
    raise UserError(f"--set {text}: must have the form table.key=value")


def find_study(study: str) -> Path:
    """Return the path of study.toml for a name under studies/ or a path to a TOML file.

    Hyphens in a name may stand for underscores.
    """
    if study.endswith(".toml"):
        path = Path(study)
        if path.is_file():
            return path
        raise UserError(f"study {study!r}: no such file")
    known = known_studies()
    for name in (study, study.replace("-", "_")):
        if name in known:
            return known[name]
    if study.endswith(".nc"):
        raise UserError(f"study {study!r}: is a result; give its study, and --out {study}")
    near = did_you_mean(study.replace("-", "_"), known) or "; `studies` lists the names"
    raise UserError(f"study {study!r}: must be a study or the path of a .toml file{near}")


def known_studies() -> dict[str, Path]:
    """Return name -> study.toml; studies of the working folder replace those of the program."""
    roots = (Path(__file__).resolve().parents[2] / "studies", Path.cwd() / "studies")
    return {path.parent.name: path for root in roots for path in root.glob("*/study.toml")}


def read_study(study: str, scale: str | None = None, settings: list[str] | None = None) -> AnyStudy:
    """Return the checked study: a measured study if it has a table [measure], else a grid study.

    settings : overrides "table.key=value".

    Raises UserError for invalid input: first for all keys, types and ranges at every scale, then
    for combinations. Each error states file and line, if known.
    """
    overrides = settings or []
    name, path, tables, scales = _located_tables(study, scale, overrides)
    with errors_located(path, scale or "", overrides):
        checked: AnyStudy
        if "measure" in tables:
            checked = read_measured(name, path.parent, tables)
        else:
            checked = read_grid_study(name, path.parent, tables, scales=scales)
    return replace(checked, scale=scale or "")


def known_scales(study: str) -> list[str]:
    """Return the names of the scales of a study."""
    _, others = load_tables(find_study(study), None, [])
    return list(others)


def read_scene(study: str, scale: str | None, settings: list[str], quantities: list[str]) -> Study:
    """Return a study of one point as the scene of a single line, with the given quantities.

    Comparisons are dropped. Raises UserError as ``read_study`` does, and for a study of several
    points.
    """
    name, path, tables, _ = _located_tables(study, scale, settings)
    if "measure" in tables:
        raise UserError(f"{study}: measures the program itself; choose a study that has a scene")
    if "programme" not in as_table("scene", tables.get("scene", {})):
        raise UserError(f"{study}: has no motion over time; add a [[scene.programme]]")
    tables.pop("compare", None)
    for table, extra in (
        ("study", {"realizations": 1, "realizations_per_block": 1}),
        ("scene", {"quantities": quantities}),
    ):
        tables[table] = {**as_table(table, tables.get(table, {})), **extra}
    with errors_located(path, scale or "", settings):
        return read_grid_study(name, path.parent, tables, one_point=True)


def _located_tables(
    study: str, scale: str | None, settings: list[str]
) -> tuple[str, Path, dict, dict]:
    """Return name, file, tables and other scales of a study."""
    path = find_study(study)
    folder = path.parent.resolve() if path.parent.name in ("", "..") else path.parent
    name = folder.name if path.name == "study.toml" else path.stem
    try:
        return name, path, *load_tables(path, scale, settings)
    except RecursionError:
        raise UserError(f"{path}: brackets are nested too deeply to be read") from None


KEY_OF_MESSAGE = re.compile(r"([\w.\"\[\]-]+?)(?: = |: | holds )")


@contextmanager
def errors_located(path: Path, scale: str, settings: list[str]) -> Iterator[None]:
    """Add file and line of the key to every UserError raised in the block.

    scale : name of the selected scale. settings : overrides "table.key=value", which have no line.
    """
    try:
        yield
    except UserError as error:
        overridden = [setting.partition("=")[0].strip() for setting in settings]
        text = path.read_text(encoding="utf-8")
        for single in error.errors:
            key = key_of(single.args[0])
            is_override = any(
                key == other or key.startswith((f"{other}.", f"{other}[")) for other in overridden
            )
            line = None if is_override else line_of(text, key, scale)
            single.place = f" ({path}, line {line})" if line else ""
        raise


def key_of(message: str) -> str:
    """Return the key at the beginning of a message, such as grid.hurst[0], or ""."""
    match = KEY_OF_MESSAGE.match(message)
    return match[1] if match else ""


def line_of(text: str, key: str, scale: str = "") -> int | None:
    """Return the line number of a key, or of the table in which the key is missing.

    scale : name of the selected scale, whose tables have priority. None if the key has no line.
    """
    lines, whole = text.splitlines(), tomllib.loads(text)
    parts = [part.strip('"') for part in re.split(r"[.\[\]]+", key) if part]
    best = (0, False, 0)
    for root in (), ("scales", scale):
        path = [*root, *parts]
        depth = _depth(whole, path)
        if depth > len(root):
            number = _first_line(lines, path, depth)
            header = lines[number - 1].lstrip().startswith("[")
            best = max(best, (depth - len(root), bool(root) and not header, -number))
    return -best[2] if best[0] else None


def _first_line(lines: list[str], path: list[str], depth: int) -> int:
    """Return the number of the line that defines the first ``depth`` parts of a path."""

    def reached(count: int) -> int:
        return _depth(_readable(lines, count)[1], path)

    last = bisect_left(range(len(lines) + 1), depth, key=reached)
    return 1 + _readable(lines, last - 1)[0]


def _readable(lines: list[str], most: int) -> tuple[int, dict[str, Any]]:
    """Return the largest number (<= ``most``) of first lines that are valid TOML, and tables."""
    for count in range(most, 0, -1):
        with contextlib.suppress(tomllib.TOMLDecodeError):
            return count, tomllib.loads("\n".join(lines[:count]))
    return 0, {}


def _depth(tables: Any, path: list[str]) -> int:
    """Return the number of leading parts of a path that exist in the tables."""
    for depth, part in enumerate(path):
        if isinstance(tables, list) and part.isdigit() and int(part) < len(tables):
            tables = tables[int(part)]
        elif isinstance(tables, dict) and part in tables:
            tables = tables[part]
        else:
            return depth
    return len(path)
