"""Read study.toml: find it, apply the scale and --set, check every key, build the Study."""

import copy
import json
import tomllib
from pathlib import Path
from typing import Any

from kernels.surfaces.self_affine import NORMALISATIONS
from workflow.errors import UserError
from workflow.study.checks import (
    _flag,
    _required,
    as_table,
    as_text,
    check_keys,
    choice,
    integer,
    positive,
)
from workflow.study.cluster import read_cluster
from workflow.study.grid import AXES, _grid
from workflow.study.measured import Measured, read_measured
from workflow.study.numerics import NUMERICS, read_variants
from workflow.study.study import Study, _scene


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


TABLES: dict[str, tuple[str, ...]] = {
    "study": ("title", "seed", "realizations", "realizations_per_block"),
    "material": ("shear_modulus", "relaxation_time"),
    "surface": ("length", "normalisation", "snap_spacing"),
    "grid": AXES,
    "scene": ("quantities", "indentation_rate"),
    "numerics": NUMERICS,
}

BY_NAME = ("compare", "scales")  # tables of tables, named by the user


def find_study(study: str) -> Path:
    """Return the path of study.toml for a name under studies/ or a path to a TOML file."""
    if study.endswith(".toml"):
        path = Path(study)
        if path.is_file():
            return path
        raise UserError(f"study {study!r}: no such file")
    known = known_studies()
    if study in known:
        return known[study]
    names = ", ".join(sorted(known))
    raise UserError(f"study {study!r}: not among {names}, nor the path of a .toml file")


def known_studies() -> dict[str, Path]:
    """Return name -> study.toml of all studies, those of the working folder before our own."""
    roots = (Path(__file__).resolve().parents[2] / "studies", Path.cwd() / "studies")
    return {path.parent.name: path for root in roots for path in root.glob("*/study.toml")}


def read_study(
    study: str, scale: str | None = None, settings: list[str] | None = None
) -> Study | Measured:
    """Return the checked study, measured where it has a table [measure], else of a grid.

    settings : "table.key=value" overrides.

    Raises UserError, one line, for anything a user can have got wrong.
    """
    path = find_study(study)
    name = path.parent.name if path.name == "study.toml" else path.stem
    try:
        tables = load_tables(path, scale, settings or [])
        if "measure" in tables:
            return read_measured(name, path.parent, tables)
        return _build(name, path.parent, tables)
    except RecursionError:
        raise UserError(f"{path}: holds brackets within brackets too deep to read") from None


def _build(name: str, folder: Path, tables: dict) -> Study:
    check_keys("", tables, (*TABLES, *BY_NAME, "cluster"))
    cluster = read_cluster(as_table("cluster", tables.pop("cluster", {})))
    for table, known in TABLES.items():
        check_keys(f"{table}.", as_table(table, tables.get(table, {})), known)
    head = tables.get("study", {})
    realizations = _required(tables, "study", "realizations", lambda k, v: integer(k, v, 2))
    block = integer("study.realizations_per_block", head.get("realizations_per_block", 1), 1)
    if realizations % block or realizations // block < 2:
        raise UserError(
            f"study.realizations_per_block = {block}: must divide realizations = {realizations} "
            "into at least 2 blocks, from which standard errors are estimated"
        )
    length = _required(tables, "surface", "length", positive)
    surface = tables["surface"]
    return Study(
        name=name,
        folder=folder,
        text=json.dumps(tables, indent=1, sort_keys=True, default=str),
        title=as_text("study.title", head.get("title", name)),
        seed=integer("study.seed", head.get("seed", 0), 0),
        realizations=realizations,
        realizations_per_block=block,
        shear_modulus=_required(tables, "material", "shear_modulus", positive),
        relaxation_time=_required(tables, "material", "relaxation_time", positive),
        length=length,
        normalisation=choice(
            "surface.normalisation", surface.get("normalisation", "modal"), NORMALISATIONS
        ),
        grid=_grid(tables, length, _flag("surface.snap_spacing", surface, False)),
        scene=_scene(tables.get("scene", {})),
        variants=read_variants(tables),
        cluster=cluster,
    )
