"""Every table of study.toml, and the one check of its keys: all that is wrong is said at once."""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..ground import ErrorCollector, UserError
from .axes import with_lists
from .cluster import CLUSTER
from .effects import ARRHENIUS, DRIVE, MATERIAL, SCENE, SEGMENTS, WLF
from .grid import GRID
from .numerics import NUMERICS
from .settings import Key, as_table, as_text, check_keys, checked, integer
from .surfaces import SURFACE
from .variants import COMPARE

Keys = Mapping[str, Key]
HEAD = {
    "title": Key(
        as_text,
        "The line that heads the output of `plan`, the figure and the result file.",
        default="",
        usual="the name of the study",
    ),
    "seed": Key(
        partial(integer, least=0),
        "The number from which the random lines are drawn, together with H, the number of "
        "elements and the index of the realization.",
        "Doubled, or changed in any way, it draws other lines: estimates change within their "
        "standard errors.",
        default=0,
    ),
}
STUDY = HEAD | {
    "realizations": Key(
        partial(integer, least=2),
        "The number of lines over which estimates are averaged. For random lines it is rounded up "
        "to whole quartets, four lines from one set of random phases, and to two blocks.",
        "Doubled, standard errors fall by √2, and the time doubles but for lines that are stored "
        "already.",
        default=None,
        usual='as many as were measured with `surface.lines = "measured"`, else required',
    ),
    "realizations_per_block": Key(
        partial(integer, least=1),
        "The number of lines whose mean is one record of the store, and which the jackknife "
        "leaves out at a time. It must divide `realizations` into two blocks at least; for random "
        "lines it is rounded up to a multiple of four.",
        "Doubled, the store holds half as many records, and with fewer than 32 blocks standard "
        "errors are themselves known less well.",
        default=1,
    ),
}
# A scene is a study of one point, for which one line may do.
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
KNOWN = (*TABLES, "compare", "scales")
WITHIN: dict[str, dict[str, Keys]] = {  # the tables that stand in one
    "material": {"material.wlf": WLF, "material.arrhenius": ARRHENIUS},
    "scene": {
        "scene.drive": DRIVE,
        **{f"scene.programme.{kind}".removesuffix(".file"): SEGMENTS[kind] for kind in SEGMENTS},
    },
}
ALL_TABLES: dict[str, Keys] = {  # of a study of a grid
    where: keys
    for name, table in TABLES.items()
    for where, keys in {name: table, **WITHIN.get(name, {})}.items()
}


def checked_tables(
    tables: Mapping[str, Any], scales: Mapping[str, Any], study: Keys
) -> dict[str, dict[str, Any]]:
    """Return the checked values of every table of a study of a grid, empty where it has none.

    scales : those that are not asked for; what their values come to together, as the number of
    points, is left to the day when they are. study : the keys of the table [study]. Raises
    UserError for the keys, types and ranges of them all at once.
    """
    complaints, keys = ErrorCollector(), {**TABLES, "study": study}
    found = _checked("", tables, keys, complaints)
    for name, scale in scales.items():
        with complaints:
            own = as_table(f"scales.{name}", scale)
            _checked(f"scales.{name}.", own, keys, complaints)
    complaints.raise_collected()
    return {name: {} for name in (*TABLES, "compare")} | found


def _checked(
    where: str, tables: Mapping[str, Any], keys: Mapping[str, Keys], complaints: ErrorCollector
) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = {}
    for name, table in tables.items():
        with complaints:
            check_keys(where, [name], KNOWN)
            if name == "compare":
                found[name] = {}
                for label, own in as_table(f"{where}{name}", table).items():
                    with complaints:
                        found[name][label] = checked(f"{where}{name}.{label}", own, COMPARE)
            elif name in keys:
                _check_place(f"{where}{name}", table, keys[name])
                found[name] = checked(f"{where}{name}", table, keys[name])
    return found


def _check_place(where: str, table: object, keys: Keys) -> None:
    """Raise UserError for a key that another table has, as grid.temperature, naming that table."""
    for key in as_table(where, table):
        homes = [name for name, own in TABLES.items() if key in own]
        if key not in keys and len(homes) == 1:
            raise UserError(f"{where}.{key}: unknown key; it belongs in [{homes[0]}]")
