"""The study: everything a user says in study.toml, checked once and then immutable."""

import json
import math
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

from ...kernels import QUARTET
from ..errors import UserError
from .cluster import HERE, Cluster, read_cluster
from .effects import MATERIAL, SCENE, Material, Scene, check_quantities, read_scene
from .grid import GRID, Grid, read_grid
from .numerics import NUMERICS, Numerics
from .settings import Key, as_text, check_keys, integer, read_table
from .surfaces import SURFACE, Profile, Surface, read_surface
from .variants import check_accuracy, read_variants

MOST_BLOCKS = 100_000  # of one problem; the block means of some are in memory at a time
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
    name: str
    folder: Path  # where study.toml and its figure script are
    text: str  # the settings in force, after scale and --set, as JSON
    title: str
    seed: int
    scale: str = ""  # which of its scales is in force

    @property
    def axes(self) -> tuple[str, ...]:
        """The axes that a result has; none where there is no grid."""
        return ()


@dataclass(frozen=True, kw_only=True)
class Study(AnyStudy):
    """A checked study of a grid, in SI units."""

    kind: ClassVar[str] = "grid"
    realizations_asked: int  # as the study says
    realizations: int  # of random lines in whole quartets, whole blocks and two blocks at least
    realizations_per_block: int
    grid: Grid
    scene: Scene
    variants: dict[str, Numerics]  # "" is the study itself, the others are its comparisons
    materials: dict[str, Material]  # of the same labels
    surfaces: dict[str, Surface]  # likewise; all of one length, spacing and roughness
    cluster: Cluster = HERE  # no part of the results' identity

    @property
    def material(self) -> Material:
        """The material of the study itself."""
        return self.materials[""]

    @property
    def surface(self) -> Surface:
        """The surface of the study itself."""
        return self.surfaces[""]

    @property
    def axes(self) -> tuple[str, ...]:
        """The dimensions of the grid: those that every result has, then those of this scene."""
        return tuple(self.grid)

    @property
    def blocks(self) -> int:
        """Number of blocks of realizations, the units of the jackknife."""
        return self.realizations // self.realizations_per_block

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the grid, over its axes."""
        return tuple(len(values) for values in self.grid.values())


def read_grid_study(
    name: str,
    folder: Path,
    tables: dict[str, Any],
    one_point: bool = False,
    profile: Profile | None = None,
) -> Study:
    """Return the checked study. Raises UserError, one line, for what a user can get wrong.

    one_point : whether it is a scene, a study of one point that a single line may do for.
    profile : lines in place of a table [surface].
    """
    check_keys("", tables, (*TABLES, *BY_NAME, "cluster"))
    cluster = read_cluster(tables.pop("cluster", {}))
    head = study_head(name, folder, tables, ONE_POINT if one_point else STUDY)
    surface = (
        read_surface(tables.get("surface", {}), folder)
        if profile is None
        else Surface(profile.measured_length, profile=profile)
    )
    variants, materials, surfaces = read_variants(tables, folder, surface)
    scene = read_scene(tables.get("scene", {}), folder, materials.values())
    grid = read_grid(tables.get("grid", {}), surface, scene, materials[""].temperatures)
    head["realizations"] = _realizations(head["realizations"], surfaces)
    head["realizations_asked"] = head["realizations"]
    single = one_point and head["realizations"] == 1
    if not single:
        drawn = not any(surface.profile for surface in surfaces.values())
        head |= _blocks(head["realizations"], head["realizations_per_block"], drawn)
    alone = single and not scene.holds
    check_quantities(scene, materials, alone)
    check_accuracy(variants, materials, scene, surface)
    found = Study(
        **head,
        grid=grid,
        scene=scene,
        variants=variants,
        materials=materials,
        surfaces=surfaces,
        cluster=cluster,
    )
    return _one_point(found) if one_point else found


def _realizations(given: int | None, surfaces: dict[str, Surface]) -> int:
    """Return how many lines there are; as many as were measured where nothing is said."""
    lines = None
    for surface in surfaces.values():
        if surface.profile is not None and surface.lines == "measured":
            lines = len(surface.profile.heights)
    if given is None and lines is None:
        raise UserError("study.realizations: missing")
    if lines is not None and given is not None and given > lines:
        raise UserError(f"study.realizations = {given}: only {lines} lines were measured")
    return given or lines or 1


def _blocks(realizations: int, block: int, drawn: bool) -> dict[str, int]:
    """Return the counts of realizations, in all and per block. Raises UserError.

    drawn : whether lines are drawn: then both are rounded up, and quartets lie in one block.
    """
    given = f"study.realizations_per_block = {block}"
    if realizations % block or realizations // block < 2:
        raise UserError(
            f"{given}: must divide realizations = {realizations} "
            "into at least 2 blocks, from which standard errors are estimated"
        )
    if drawn:
        block = QUARTET * math.ceil(block / QUARTET)
        realizations = block * max(2, math.ceil(realizations / block))
    if realizations // block > MOST_BLOCKS:
        raise UserError(
            f"{given}: divides realizations = {realizations} into "
            f"more than {MOST_BLOCKS} blocks; set it to {-(-realizations // MOST_BLOCKS)} or more"
        )
    return {"realizations": realizations, "realizations_per_block": block}


def _one_point(study: Study) -> Study:
    for axis, values in study.grid.items():
        if len(values) > 1 and axis != "hold":
            raise UserError(f"grid.{axis} = {list(values)!r:.40}: a scene has one value of it")
    return study


def study_head(
    name: str, folder: Path, tables: dict[str, Any], keys: dict[str, Key]
) -> dict[str, Any]:
    """Return the fields of a study that its file and the table [study] give. Raises UserError."""
    head = read_table("study", tables.get("study", {}), keys)
    text = json.dumps(tables, indent=1, sort_keys=True, default=str)
    return {"name": name, "folder": folder, "text": text} | head | {"title": head["title"] or name}
