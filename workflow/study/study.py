"""The study: everything a user says in study.toml, checked once and then immutable."""

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from ...kernels import QUARTET
from ..ground import UserError
from .axes import ALL_AXES, Grid, Parts, parts_at, separated, with_value
from .cluster import THIS_MACHINE, Cluster, read_cluster
from .effects import FOUNDATION, PROGRAMME_AXES, Material, Scene, check_quantities, read_scene_table
from .grid import read_grid
from .numerics import Numerics
from .settings import filled
from .surfaces import Profile, Surface, read_surface
from .tables import ONE_POINT, STUDY, checked_tables
from .variants import check_bodies, check_numerics, read_variants

MAX_BLOCKS = 100_000  # of one problem; the block means of some are in memory at a time


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
    realizations_requested: int  # as the study says
    realizations: int  # of random lines in whole quartets, whole blocks and two blocks at least
    realizations_per_block: int
    grid: Grid
    scene: Scene
    variants: dict[str, Numerics]  # "" is the study itself, the others are its comparisons
    materials: dict[str, Material]  # of the same labels
    surfaces: dict[str, Surface]  # likewise; all of one length, spacing and roughness
    pressures: tuple[float, ...] = ()  # Pa, nominal, where they are given in place of forces
    cluster: Cluster = THIS_MACHINE  # no part of the results' identity

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
    def descriptions(self) -> list[tuple[str, str]]:
        """What files and arrays were read as, in sentences, each once with what it holds."""
        found = [("lines", surface.description) for surface in self.surfaces.values()]
        for material in self.materials.values():
            shifts = material.shifts.told if material.shifts else ""
            found += [("branches", material.description), ("shifts", shifts)]
        found += [("programme", said) for said in self.scene.sampled]
        found.append(("indentation", self.scene.indentation_description))
        return [each for each in dict.fromkeys(found) if each[1]]

    def parts(self, label: str, axes: Iterable[str]) -> list[Parts]:
        """Return what a variant is made of at every point of some axes, the last one fastest.

        At the first value of the others.
        """
        own = Parts(self.materials[label], self.surfaces[label], self.scene)
        return parts_at(own, self.grid, axes)

    def force_share(self, label: str) -> float:
        """Return the normal force on a variant over that of the study: 1 unless pressures count."""
        if not self.pressures:
            return 1.0
        return self.surfaces[label].pressed_area / self.surface.pressed_area

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
    tables: Mapping[str, Any],
    one_point: bool = False,
    profile: Profile | None = None,
    scales: Mapping[str, Any] | None = None,
) -> Study:
    """Return the checked study.

    Raises UserError for anything a user can have got wrong: all keys, types and ranges at once,
    then what does not go together.

    one_point : whether it is a scene, a study of one point that a single line may do for.
    profile : lines in place of a table [surface]. scales : those that are not asked for, of which
    the keys are checked as well.
    """
    head_keys = ONE_POINT if one_point else STUDY
    given = checked_tables(tables, scales or {}, head_keys)
    cluster = read_cluster(given["cluster"])
    written = {name: table for name, table in tables.items() if name != "cluster"}
    head = study_head(name, folder, written, filled("study", given["study"], head_keys))
    given, several = separated(given)
    surface = (
        read_surface(given["surface"], folder, given["scene"].get("body", FOUNDATION))
        if profile is None
        else Surface(profile.measured_length, profile=profile)
    )
    variants, materials, surfaces = read_variants(given, folder, surface)
    surface = surfaces[""]
    _check_each(given, several, folder, surface)
    scene = read_scene_table(given["scene"], folder, materials.values())
    parts = Parts(materials[""], surface, scene)
    grid = read_grid(given["grid"], written.get("grid", {}), parts, several)
    asked, block = given["study"].get("realizations"), given["study"].get("realizations_per_block")
    if one_point and asked is None:
        asked = head["realizations"]
    head |= _lines_in_blocks(asked, block, surfaces)
    single = head["realizations"] == 1
    surfaces = {label: _told_of_blocks(own, head) for label, own in surfaces.items()}
    alone = one_point and single and not scene.listed
    check_quantities(scene, materials, alone)
    check_bodies(scene, surfaces)
    check_numerics(variants, materials, scene, surfaces)
    for axis, values in grid.items() if one_point else ():
        if len(values) > 1 and axis not in PROGRAMME_AXES:
            raise UserError(f"grid.{axis} = {list(values)!r:.40}: a scene has one value of it")
    return Study(
        **head,
        grid=grid,
        scene=scene,
        variants=variants,
        materials=materials,
        surfaces=surfaces,
        pressures=given["grid"].get("normal_pressure", ()),
        cluster=cluster,
    )


def _check_each(
    tables: dict[str, dict[str, Any]], several: Grid, folder: Path, surface: Surface
) -> None:
    """Raise UserError where a value of an axis is refused; tables : with the first of them."""
    for axis, (_, *others) in several.items():
        row = ALL_AXES[axis]
        for value in others:
            each = with_value(tables, row, value)
            own = read_surface(each["surface"], folder) if row.table == "surface" else surface
            read_variants(each, folder, own)


def _lines_in_blocks(
    asked: int | None, block: int | None, surfaces: dict[str, Surface]
) -> dict[str, int]:
    """Return the counts of lines: as asked for, in all, and per block. Raises UserError.

    asked, block : as the study gives them. Without them there are as many lines as were measured,
    in blocks of those that are alike; a line alone is its own block.
    """
    measured = (own.profile for own in surfaces.values() if own.lines == "measured")
    profile = next(filter(None, measured), None)  # of the first whose measured lines slide
    lines = None if profile is None else len(profile.heights)
    if asked is None and lines is None:
        raise UserError("study.realizations: missing")
    if lines is not None and asked is not None and asked > lines:
        only = "1 line was" if lines == 1 else f"{lines} lines were"
        raise UserError(
            f"study.realizations = {asked}: only {only} measured; of random lines like them, "
            'surface.lines = "random-phase", there may be more'
        )
    realizations = asked or lines or 1
    found = {"realizations_requested": realizations}
    if realizations == 1:
        return found | {"realizations": 1, "realizations_per_block": 1}
    if block is None and profile is not None and profile.correlation is not None:
        taken, size = profile.correlation.whole_blocks(realizations, every=asked is not None)
        return found | {"realizations": taken, "realizations_per_block": size}
    drawn = any(own.profile is None and own.body == FOUNDATION for own in surfaces.values())
    return found | _blocks(realizations, block or 1, drawn)


def _told_of_blocks(surface: Surface, head: Mapping[str, Any]) -> Surface:
    """Return a surface that tells what its standard errors rest on."""
    profile = surface.profile
    if profile is None or surface.lines != "measured":
        return surface
    block, lines = head["realizations_per_block"], head["realizations"]
    if lines == 1:
        what = "line" if surface.body == FOUNDATION else "map"
        said = f"one {what}, of which no standard error is known: errors are NaN"
    elif profile.correlation is None:
        return surface
    else:
        said = (
            f"neighbouring lines are alike (correlation {profile.correlation.correlation:.2f}; "
            f"{profile.correlation.lines:.3g} are worth one): {lines} in blocks of {block}"
        )
        if block < profile.correlation.lines:
            said += (
                ", too short for standard errors, which are too small: take "
                f"study.realizations_per_block = {profile.correlation.block}"
            )
    return surface._replace(profile=profile._replace(notes=f"{profile.notes}; {said}"))


def _blocks(realizations: int, block: int, drawn: bool) -> dict[str, int]:
    """Return the counts of realizations, in all and per block. Raises UserError.

    drawn : whether lines are drawn: then both are rounded up, and quartets lie in one block. Maps
    come one by one.
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
    if realizations // block > MAX_BLOCKS:
        raise UserError(
            f"{given}: divides realizations = {realizations} into "
            f"more than {MAX_BLOCKS} blocks; set it to {-(-realizations // MAX_BLOCKS)} or more"
        )
    return {"realizations": realizations, "realizations_per_block": block}


def study_head(
    name: str, folder: Path, tables: Mapping[str, Any], head: dict[str, Any]
) -> dict[str, Any]:
    """Return the fields of a study that its file and the values of its table [study] give."""
    text = json.dumps(tables, indent=1, sort_keys=True, default=str)
    return {"name": name, "folder": folder, "text": text} | head | {"title": head["title"] or name}
