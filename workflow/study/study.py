"""The study: everything a user says in study.toml, checked once and then immutable."""

import json
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from kernels.surfaces.self_affine import NORMALISATIONS
from workflow.errors import UserError
from workflow.study.checks import (
    Key,
    as_text,
    check_keys,
    choice,
    flag,
    integer,
    positive,
    read_table,
)
from workflow.study.cluster import HERE, Cluster, read_cluster
from workflow.study.grid import AXES, GRID, Grid, read_grid
from workflow.study.numerics import NUMERICS, Numerics, read_variants
from workflow.study.quantities import USUAL, asked_for

HEAD = {"title": Key(as_text, ""), "seed": Key(partial(integer, least=0), 0)}
STUDY = HEAD | {
    "realizations": Key(partial(integer, least=2)),
    "realizations_per_block": Key(partial(integer, least=1), 1),
}
MATERIAL = {"shear_modulus": Key(positive), "relaxation_time": Key(positive)}
SURFACE = {
    "length": Key(positive),
    "normalisation": Key(partial(choice, known=NORMALISATIONS), "modal"),
    "snap_spacing": Key(flag, False),
}
SCENE = {"quantities": Key(asked_for, USUAL), "indentation_rate": Key(flag, True)}
TABLES = {
    "study": STUDY,
    "material": MATERIAL,
    "surface": SURFACE,
    "grid": GRID,
    "scene": SCENE,
    "numerics": NUMERICS,
}
BY_NAME = ("compare", "scales")  # tables of tables, named by the user


@dataclass(frozen=True, kw_only=True)
class AnyStudy:
    """What studies of every kind have."""

    kind: ClassVar[str]
    axes: ClassVar[tuple[str, ...]]  # that every result of this kind has
    name: str
    folder: Path  # where study.toml and its figure script are
    text: str  # the settings in force, after scale and --set, as JSON
    title: str
    seed: int


class Scene(NamedTuple):
    """What is simulated."""

    quantities: tuple[str, ...] = USUAL
    indentation_rate: bool = True


@dataclass(frozen=True, kw_only=True)
class Study(AnyStudy):
    """A checked study of a grid, in SI units."""

    kind: ClassVar[str] = "grid"
    axes: ClassVar[tuple[str, ...]] = AXES
    realizations: int
    realizations_per_block: int
    shear_modulus: float  # Pa
    relaxation_time: float  # s
    length: float  # m
    normalisation: str
    grid: Grid
    scene: Scene
    variants: dict[str, Numerics]  # "" is the study itself, the others are its comparisons
    cluster: Cluster = HERE  # no part of the results' identity

    @property
    def blocks(self) -> int:
        """Number of blocks of realizations, the units of the jackknife."""
        return self.realizations // self.realizations_per_block

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the six-dimensional grid."""
        return tuple(len(self.grid[axis]) for axis in AXES)


def read_grid_study(name: str, folder: Path, tables: dict[str, Any]) -> Study:
    """Return the checked study. Raises UserError, one line, for what a user can get wrong."""
    check_keys("", tables, (*TABLES, *BY_NAME, "cluster"))
    cluster = read_cluster(tables.pop("cluster", {}))
    head = study_head(name, folder, tables, STUDY)
    realizations, block = head["realizations"], head["realizations_per_block"]
    if realizations % block or realizations // block < 2:
        raise UserError(
            f"study.realizations_per_block = {block}: must divide realizations = {realizations} "
            "into at least 2 blocks, from which standard errors are estimated"
        )
    surface = read_table("surface", tables.get("surface", {}), SURFACE)
    snap = surface.pop("snap_spacing")
    scene = Scene(**read_table("scene", tables.get("scene", {}), SCENE))
    steady_alone = scene.quantities == ("steady",)
    return Study(
        **head,
        **read_table("material", tables.get("material", {}), MATERIAL),
        **surface,
        grid=read_grid(tables.get("grid", {}), surface["length"], snap, steady_alone),
        scene=scene,
        variants=read_variants(tables),
        cluster=cluster,
    )


def study_head(
    name: str, folder: Path, tables: dict[str, Any], keys: dict[str, Key]
) -> dict[str, Any]:
    """Return the fields of a study that its file and the table [study] give. Raises UserError."""
    head = read_table("study", tables.get("study", {}), keys)
    text = json.dumps(tables, indent=1, sort_keys=True, default=str)
    return {"name": name, "folder": folder, "text": text} | head | {"title": head["title"] or name}
