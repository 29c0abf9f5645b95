"""Tables of study.toml with what is said of their keys: what the reference page is made of."""

from collections.abc import Mapping
from typing import NamedTuple

from ..cluster import CLUSTER
from ..effects import HOLD, MATERIAL, OSCILLATE, RAMP, SCENE, SLIDE, WLF
from ..grid import GRID
from ..numerics import NUMERICS
from ..settings import Key, as_text
from ..study import STUDY
from ..surfaces import SURFACE
from . import material, numerics, scene, study, surface
from .text import Text
from .values import default_of, values_of

FILE = {"file": Key(as_text)}  # the one segment that is no table
PAIRS: dict[str, tuple[Mapping[str, Key], Mapping[str, Text]]] = {
    "study": (STUDY, study.STUDY),
    "material": (MATERIAL, material.MATERIAL),
    "material.wlf": (WLF, material.WLF),
    "surface": (SURFACE, surface.SURFACE),
    "grid": (GRID, surface.GRID),
    "scene": (SCENE, scene.SCENE),
    "scene.programme.slide": (SLIDE, scene.SLIDE),
    "scene.programme.hold": (HOLD, scene.HOLD),
    "scene.programme.ramp": (RAMP, scene.RAMP),
    "scene.programme.oscillate": (OSCILLATE, scene.OSCILLATE),
    "scene.programme": (FILE, scene.FILE),
    "numerics": (NUMERICS, numerics.NUMERICS),
    "cluster": (CLUSTER, study.CLUSTER),
}


class DescribedKey(NamedTuple):
    """One key with all that is said of it."""

    name: str
    values: str
    unit: str
    default: str
    means: str
    changes: str


Table = tuple[DescribedKey, ...]


def described_tables() -> dict[str, Table]:
    """Return the keys of every table of a study of a grid, described.

    Raises KeyError for a key without a text, and for a text without a key.
    """
    return {name: described(name, *pair) for name, pair in PAIRS.items()}


def described(where: str, keys: Mapping[str, Key], texts: Mapping[str, Text]) -> Table:
    """Return the keys of one table, described; ``where`` names it. Raises KeyError likewise."""
    if keys.keys() != texts.keys():
        raise KeyError(f"{where}: {sorted(keys.keys() ^ texts.keys())} lack a key or a text")
    return tuple(
        DescribedKey(
            name,
            texts[name].values or values_of(key.check),
            texts[name].unit,
            texts[name].default or default_of(key),
            texts[name].means,
            texts[name].changes,
        )
        for name, key in keys.items()
    )
