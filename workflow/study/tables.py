"""All tables of study.toml, and the check of their keys, which reports all errors together."""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..ground import ErrorCollector, UserError
from .axes import with_lists
from .cluster import CLUSTER
from .effects import MATERIAL, SCENE, SEGMENTS
from .grid import GRID
from .numerics import NUMERICS
from .settings import OPTIONAL, Key, as_table, as_text, check_keys, checked, integer
from .surfaces import SURFACE
from .variants import COMPARE

Keys = Mapping[str, Key]
HEAD = {
    "title": Key(
        as_text,
        "The title in `plan`, the figure and the result file.",
        default="",
        usual="the name of the study",
    ),
    "seed": Key(
        partial(integer, least=0),
        "The seed of the random lines.",
        "Doubled, other lines are drawn.",
        default=0,
    ),
}
STUDY = HEAD | {
    "realizations": OPTIONAL(
        partial(integer, least=2),
        "The number of lines over which estimates are averaged. For random lines it is rounded up "
        "to whole quartets and to at least two blocks.",
        "Doubled, standard errors fall by √2 and the time doubles.",
        usual='all measured lines with `surface.lines = "measured"`, else required',
    ),
    "realizations_per_block": Key(
        partial(integer, least=1),
        "The number of lines in a block, whose mean is one record of the store. It must divide "
        "`realizations` into at least two blocks; for random lines it is rounded up to a multiple "
        "of four.",
        "Doubled, the store holds half as many records; standard errors are less reliable with "
        "fewer than 32 blocks.",
        default=1,
    ),
}
# A scene is a study of one point and may have a single line.
ONE_LINE = replace(STUDY["realizations"], check=partial(integer, least=1), default=1)
ONE_POINT = STUDY | {"realizations": ONE_LINE}
TABLES = {
    "study": STUDY,
    "material": with_lists("material", MATERIAL),
    "surface": with_lists("surface", SURFACE),
    "grid": GRID,
    "scene": SCENE,
    "numerics": NUMERICS,
    "cluster": CLUSTER,
}
TABLE_NAMES = (*TABLES, "compare", "scales")
PROGRAMME = {f"scene.programme.{kind}".removesuffix(".file"): SEGMENTS[kind] for kind in SEGMENTS}
ALL_TABLES: dict[str, Keys] = {  # tables of a grid study, each followed by the tables in it
    where: keys
    for name, table in TABLES.items()
    for where, keys in {
        name: table,
        **{
            f"{name}.{key}": one.check.keywords["keys"]
            for key, one in table.items()
            if isinstance(one.check, partial) and "keys" in one.check.keywords
        },
        **(PROGRAMME if name == "scene" else {}),
    }.items()
}


def checked_tables(
    tables: Mapping[str, Any], scales: Mapping[str, Any], study: Keys
) -> dict[str, dict[str, Any]]:
    """Return the checked values of every table of a grid study, empty for a missing table.

    scales : tables of the scales that are not selected. Their keys and values are checked, but
    not their combination, such as the number of points. study : keys of the table [study].
    Raises UserError with all invalid keys, types and ranges.
    """
    errors, keys = ErrorCollector(), {**TABLES, "study": study}
    values = _checked("", tables, keys, errors)
    for name, scale in scales.items():
        with errors:
            _checked(f"scales.{name}.", as_table(f"scales.{name}", scale), keys, errors)
    errors.raise_collected()
    return {name: {} for name in (*TABLES, "compare")} | values


def _checked(
    where: str, tables: Mapping[str, Any], keys: Mapping[str, Keys], errors: ErrorCollector
) -> dict[str, dict[str, Any]]:
    values: dict[str, dict[str, Any]] = {}
    for name, table in tables.items():
        with errors:
            check_keys(where, [name], TABLE_NAMES)
            if name == "compare":
                values[name] = {}
                for label, comparison in as_table(f"{where}{name}", table).items():
                    with errors:
                        values[name][label] = checked(f"{where}{name}.{label}", comparison, COMPARE)
            elif name in keys:
                _check_place(f"{where}{name}", table, keys[name])
                values[name] = checked(f"{where}{name}", table, keys[name])
    return values


def _check_place(where: str, table: object, keys: Keys) -> None:
    """Raise UserError for a key of another table, such as grid.temperature, and name that table."""
    for key in as_table(where, table):
        homes = [name for name, known in TABLES.items() if key in known]
        if key not in keys and len(homes) == 1:
            raise UserError(f"{where}.{key}: unknown key; move it to [{homes[0]}]")
