"""Read study.toml: find it, apply the scale and --set, build the Study, say where a fault is."""

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

MOST_BYTES = 2**24  # of a study.toml
BARE_LIST = re.compile(r"=\s*[-+.\d][-+.\deE_]*\s*,")  # numbers without brackets


def load_tables(path: Path, scale: str | None, settings: list[str]) -> tuple[dict, dict]:
    """Return the tables of a TOML file and its other scales; overrides are "table.key=value".

    Raises UserError for a file that is not TOML, an unknown scale and a broken override.
    """
    try:
        tables = tomllib.loads(read_plain(path, MOST_BYTES).decode())
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        place = re.search(r"at line (\d+)", str(error))
        lines = path.read_text(encoding="utf-8").splitlines() if place else []
        bare = place and BARE_LIST.search(lines[int(place[1]) - 1])
        hint = "; a list is [0.3, 0.5]" if bare else ""
        said = getattr(error, "strerror", None) or error
        raise UserError(f"{path}: cannot be read as TOML: {said}{hint}") from error
    scales = tables.pop("scales", {})
    if scale is not None:
        if scale not in as_table("scales", scales):
            known = ", ".join(scales) or "none"
            near = did_you_mean(scale, scales)
            raise UserError(f"--scale {scale}: the study knows {known}{near}")
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
    # A bare word is a string: --set numerics.scheme=exponential
    for toml in (text, f"{key}{separator}{json.dumps(value.strip())}"):
        with contextlib.suppress(tomllib.TOMLDecodeError):
            return tomllib.loads(toml)
    raise UserError(f"--set {text}: use table.key=value")


def find_study(study: str) -> Path:
    """Return the path of study.toml for a name under studies/ or a path to a TOML file.

    In a name hyphens stand for underscores as well: folders are packages of Python.
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
    names = ", ".join(sorted(known))
    near = did_you_mean(study.replace("-", "_"), known)
    raise UserError(f"study {study!r}: not among {names}, nor the path of a .toml file{near}")


def known_studies() -> dict[str, Path]:
    """Return name -> study.toml of all studies, those of the working folder before our own."""
    roots = (Path(__file__).resolve().parents[2] / "studies", Path.cwd() / "studies")
    return {path.parent.name: path for root in roots for path in root.glob("*/study.toml")}


def read_study(study: str, scale: str | None = None, settings: list[str] | None = None) -> AnyStudy:
    """Return the checked study, measured where it has a table [measure], else of a grid.

    settings : "table.key=value" overrides.

    Raises UserError for anything a user can have got wrong: all keys, types and ranges at once, at
    every scale, then what does not go together. Its place is file and line.
    """
    asked = settings or []
    name, path, tables, scales = _found(study, scale, asked)
    with placed(path, scale or "", asked):
        if "measure" in tables:
            found: AnyStudy = read_measured(name, path.parent, tables)
        else:
            found = read_grid_study(name, path.parent, tables, scales=scales)
    return replace(found, scale=scale or "")


def known_scales(study: str) -> list[str]:
    """Return the names of the scales of a study."""
    _, others = load_tables(find_study(study), None, [])
    return list(others)


def read_scene(study: str, scale: str | None, settings: list[str], quantities: list[str]) -> Study:
    """Return the scene of a study for a single line, asked for other quantities.

    Its comparisons are left out. Raises UserError as ``read_study`` does, and where the study is
    not of one point.
    """
    name, path, tables, _ = _found(study, scale, settings)
    if "measure" in tables:
        raise UserError(f"{study}: measures the program itself; it has no scene to show")
    tables.pop("compare", None)
    for table, extra in (
        ("study", {"realizations": 1, "realizations_per_block": 1}),
        ("scene", {"quantities": quantities}),
    ):
        tables[table] = {**as_table(table, tables.get(table, {})), **extra}
    with placed(path, scale or "", settings):
        return read_grid_study(name, path.parent, tables, one_point=True)


def _found(study: str, scale: str | None, settings: list[str]) -> tuple[str, Path, dict, dict]:
    """Return name, file, tables and other scales of a study."""
    path = find_study(study)
    name = path.parent.name if path.name == "study.toml" else path.stem
    try:
        return name, path, *load_tables(path, scale, settings)
    except RecursionError:
        raise UserError(f"{path}: holds brackets within brackets too deep to read") from None


NAMED = re.compile(r"([\w.\"\[\]-]+?)(?: = |: | holds )")  # what a message begins with


@contextmanager
def placed(path: Path, scale: str, settings: list[str]) -> Iterator[None]:
    """Give every UserError that is raised within its place: the file, and the line of its key.

    scale : the one in force. settings : "table.key=value" overrides, which stand in no line.
    """
    try:
        yield
    except UserError as error:
        given = [setting.partition("=")[0].strip() for setting in settings]
        text = path.read_text(encoding="utf-8")
        for each in error.errors:
            key = key_of(each.args[0])
            mine = any(key == own or key.startswith((f"{own}.", f"{own}[")) for own in given)
            line = None if mine else line_of(text, key, scale)
            each.place = f" ({path}, line {line})" if line else ""
        raise


def key_of(message: str) -> str:
    """Return the key that a message is about, as grid.hurst[0]; "" where it names none."""
    found = NAMED.match(message)
    return found[1] if found else ""


def line_of(text: str, key: str, scale: str = "") -> int | None:
    """Return the number of the line where a key stands, or the table in which it is missing.

    scale : the one in force, whose tables come before the others. None where there is no such line.
    """
    lines, whole = text.splitlines(), tomllib.loads(text)
    wanted = [part.strip('"') for part in re.split(r"[.\[\]]+", key) if part]
    best = (0, False, 0)
    for root in (), ("scales", scale):
        path = [*root, *wanted]
        depth = _depth(whole, path)
        if depth > len(root):
            number = _first_line(lines, path, depth)
            header = lines[number - 1].lstrip().startswith("[")
            best = max(best, (depth - len(root), bool(root) and not header, -number))
    return -best[2] if best[0] else None


def _first_line(lines: list[str], path: list[str], depth: int) -> int:
    """Return the number of the line with which so many parts of a path are there."""

    def reached(count: int) -> int:
        return _depth(_readable(lines, count)[1], path)

    last = bisect_left(range(len(lines) + 1), depth, key=reached)
    return 1 + _readable(lines, last - 1)[0]


def _readable(lines: list[str], most: int) -> tuple[int, dict[str, Any]]:
    """Return how many lines, so many at most, are TOML by themselves, and their tables."""
    for count in range(most, 0, -1):
        with contextlib.suppress(tomllib.TOMLDecodeError):
            return count, tomllib.loads("\n".join(lines[:count]))
    return 0, {}


def _depth(tables: Any, path: list[str]) -> int:
    """Return how many parts of a path are there."""
    for depth, part in enumerate(path):
        if isinstance(tables, list) and part.isdigit() and int(part) < len(tables):
            tables = tables[int(part)]
        elif isinstance(tables, dict) and part in tables:
            tables = tables[part]
        else:
            return depth
    return len(path)
