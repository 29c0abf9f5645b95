"""Every table of study.toml, and the one check of its keys: all that is wrong is said at once."""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..errors import Complaints
from .axes import with_lists
from .cluster import CLUSTER
from .effects import FILE, HOLD, MATERIAL, OSCILLATE, RAMP, SCENE, SLIDE, WLF
from .grid import GRID
from .numerics import NUMERICS
from .settings import Key, as_table, as_text, check_keys, checked, integer
from .surfaces import SURFACE
from .variants import COMPARE

Keys = Mapping[str, Key]
HEAD = {
    "title": Key(
        as_text,
        "A line of text that heads the output of `plan`, the figure and the result file.",
        "No number depends on it.",
        default="",
        usual="the name of the study",
    ),
    "seed": Key(
        partial(integer, least=0),
        "The number from which every random line is drawn, together with the Hurst exponent, the "
        "number of elements and the index of the realization.",
        "Another seed, doubled or not, draws other lines: every estimate changes within its "
        "standard error.",
        default=0,
    ),
}
STUDY = HEAD | {
    "realizations": Key(
        partial(integer, least=2),
        "The number of random lines over which every estimate is averaged. It is rounded up to "
        "whole quartets, four lines from one set of random phases, and to at least two blocks.",
        "Doubled, the standard errors fall by √2 and the computing time doubles. Lines that are "
        "stored already are not computed again.",
        default=None,
        usual='as many as were measured with `surface.lines = "measured"`, else required',
    ),
    "realizations_per_block": Key(
        partial(integer, least=1),
        "The number of lines whose mean is stored as one record. Blocks are the unit of the store "
        "and of the jackknife, which finds standard errors by leaving out one block, or with more "
        "than 32 blocks one group of blocks, at a time. For random lines it is rounded up to a "
        "multiple of four, and it must divide `realizations` into at least two blocks.",
        "Doubled, the store holds half as many records, and the standard error is itself known "
        "less well where there are fewer than 32 blocks. The estimates do not change.",
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
    "material": {"material.wlf": WLF},
    "scene": {
        "scene.programme.slide": SLIDE,
        "scene.programme.hold": HOLD,
        "scene.programme.ramp": RAMP,
        "scene.programme.oscillate": OSCILLATE,
        "scene.programme": FILE,
    },
}
EVERY_TABLE: dict[str, Keys] = {  # of a study of a grid
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
    complaints, keys = Complaints(), {**TABLES, "study": study}
    found = _checked("", tables, keys, complaints)
    for name, scale in scales.items():
        with complaints:
            own = as_table(f"scales.{name}", scale)
            _checked(f"scales.{name}.", own, keys, complaints)
    complaints.end()
    return {name: {} for name in (*TABLES, "compare")} | found


def _checked(
    where: str, tables: Mapping[str, Any], keys: Mapping[str, Keys], complaints: Complaints
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
                found[name] = checked(f"{where}{name}", table, keys[name])
    return found
