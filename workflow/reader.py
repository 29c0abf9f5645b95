"""Read study.toml: find it, apply the scale and --set, check every key, build the Study."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kernels.surface import NORMALISATIONS
from workflow.axes import axis_values, choice, integer, positive, snapped_spacing
from workflow.errors import UserError
from workflow.measured import read_measured
from workflow.place_reader import read_place
from workflow.read_numerics import NUMERICS, read_variants
from workflow.settings import as_table, as_text, check_keys, load_tables
from workflow.study import AXES, DEFAULT_QUANTITIES, QUANTITIES, Measured, Scene, Study

TABLES: dict[str, tuple[str, ...]] = {
    "study": ("title", "seed", "realizations", "realizations_per_block"),
    "material": ("shear_modulus", "relaxation_time"),
    "surface": ("length", "normalisation", "snap_spacing"),
    "grid": AXES,
    "scene": ("quantities", "indentation_rate"),
    "numerics": NUMERICS,
}
MOST_ELEMENTS = 1e8
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
    roots = (Path(__file__).resolve().parent.parent / "studies", Path.cwd() / "studies")
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


def _required(tables: dict, table: str, key: str, check: Callable[[str, object], Any]) -> Any:
    values = tables.get(table, {})
    if key not in values:
        raise UserError(f"{table}.{key}: missing")
    return check(f"{table}.{key}", values[key])


def _build(name: str, folder: Path, tables: dict) -> Study:
    check_keys("", tables, (*TABLES, *BY_NAME, "cluster"))
    place = read_place(as_table("cluster", tables.pop("cluster", {})))
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
        place=place,
    )


def _flag(key: str, table: dict, default: bool) -> bool:
    value = table.get(key.rpartition(".")[2], default)
    if not isinstance(value, bool):
        raise UserError(f"{key} = {value!r}: must be true or false")
    return value


def _grid(tables: dict, length: float, snap: bool) -> dict[str, tuple[float, ...]]:
    table = tables.get("grid", {})
    scene = tables.get("scene", {})
    if scene.get("quantities") == ["steady"] and "velocity_step" not in table:
        table = {**table, "velocity_step": 0.0}
    grid = {}
    for axis in AXES:
        grid[axis] = _required({"grid": table}, "grid", axis, axis_values)
        for value in grid[axis]:
            _check_range(axis, value)
    for spacing in grid["spacing"]:
        if not length / spacing < MOST_ELEMENTS:
            raise UserError(
                f"grid.spacing = {spacing!r}: more than {MOST_ELEMENTS:g} elements on "
                f"surface.length = {length!r}"
            )
    if snap:
        grid["spacing"] = snapped_spacing(length, grid["spacing"])
    for spacing in grid["spacing"]:
        elements = length / spacing
        if round(elements) < 4 or abs(elements / round(elements) - 1.0) > 1e-9:
            near = length / max(4, round(elements))
            raise UserError(
                f"grid.spacing = {spacing:g}: must divide surface.length = {length:g} into at "
                f"least 4 elements (nearest: {near!r}; or set surface.snap_spacing = true)"
            )
    return grid


def _check_range(axis: str, value: float) -> None:
    if axis == "hurst":
        if not 0.0 <= value <= 1.0:
            raise UserError(f"grid.hurst = {value!r}: must lie between 0 and 1")
    elif axis == "velocity_step":
        if value <= -1.0:
            raise UserError(f"grid.velocity_step = {value!r}: must be greater than -1 (v2 > 0)")
    else:
        positive(f"grid.{axis}", value)


def _scene(table: dict) -> Scene:
    asked = table.get("quantities", list(DEFAULT_QUANTITIES))
    if not isinstance(asked, list) or not asked:
        raise UserError(f"scene.quantities = {asked!r}: must be a list out of {QUANTITIES}")
    for quantity in asked:
        choice("scene.quantities", quantity, QUANTITIES)
    if "models" in asked and "relaxation" not in asked:
        raise UserError(f'scene.quantities = {asked!r}: "models" needs "relaxation" too')
    return Scene(
        quantities=tuple(q for q in QUANTITIES if q in asked),
        indentation_rate=_flag("scene.indentation_rate", table, True),
    )
