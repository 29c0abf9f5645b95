"""The checked, immutable study made from study.toml."""

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from ...kernels import QUARTET
from ..ground import UserError
from .axes import ALL_AXES, Grid, Parts, parts_at, separated, with_value
from .body_choice import choose_body, settle_body
from .cluster import THIS_MACHINE, Cluster
from .effects import (
    FOUNDATION,
    HALF_SPACE,
    PROGRAMME_AXES,
    Material,
    Scene,
    SceneEffects,
    check_quantities,
    read_effects,
    read_scene_table,
)
from .grid import read_grid
from .numerics import Numerics
from .settings import filled
from .surfaces import Profile, Surface, read_surface
from .tables import ONE_POINT, STUDY, checked_tables
from .variants import check_variants, read_variants

MAX_BLOCKS = 100_000  # per problem; the block means of several problems are in memory together


@dataclass(frozen=True, kw_only=True)
class AnyStudy:
    """Common part of studies of all kinds."""

    kind: ClassVar[str]
    name: str
    folder: Path  # of study.toml and its scripts
    text: str  # settings after scale and --set, as JSON
    title: str
    seed: int
    scale: str = ""  # name of the selected scale

    @property
    def axes(self) -> tuple[str, ...]:
        """Axes of the result; empty without a grid."""
        return ()


@dataclass(frozen=True, kw_only=True)
class Study(AnyStudy):
    """A checked study of a grid, in SI units."""

    kind: ClassVar[str] = "grid"
    realizations_requested: int  # as written in the study; by default all measured lines
    realizations: int  # rounded to whole blocks and, for random lines, whole quartets
    realizations_per_block: int
    grid: Grid
    scene: Scene
    variants: dict[str, Numerics]  # by label: "" is the study itself, others are comparisons
    materials: dict[str, Material]  # by label
    surfaces: dict[str, Surface]  # by label; all have the same length, spacing and roughness
    effects: dict[str, SceneEffects]  # by label
    pressures: tuple[float, ...] = ()  # Pa, nominal; empty if forces are given
    body_reason: str = ""  # for the body of the study, in words
    cluster: Cluster = THIS_MACHINE  # not part of the identity of results

    @property
    def material(self) -> Material:
        """The material of the study itself."""
        return self.materials[""]

    @property
    def surface(self) -> Surface:
        """The surface of the study itself."""
        return self.surfaces[""]

    @property
    def body_choice(self) -> str:
        """The body of the study itself and the reason for it, in words."""
        return f"{self.surface.body}: {self.body_reason}"

    @property
    def axes(self) -> tuple[str, ...]:
        """Dimensions of the grid: those of every result, then those of this scene."""
        return tuple(self.grid)

    @property
    def descriptions(self) -> list[tuple[str, str]]:
        """Contents (such as "branches") and description of each file and array that was read."""
        rows = [("lines", surface.description) for surface in self.surfaces.values()]
        for material in self.materials.values():
            shifts = material.shifts.description if material.shifts else ""
            rows += [("branches", material.description), ("shifts", shifts)]
        rows += [("shear", e.shear.description) for e in self.effects.values() if e.shear]
        rows += [("programme", history) for history in self.scene.sampled]
        rows.append(("indentation", self.scene.indentation_description))
        return [row for row in dict.fromkeys(rows) if row[1]]

    def parts(self, label: str, axes: Iterable[str]) -> list[Parts]:
        """Return material, surface and scene of a variant at every point of some axes.

        The last axis varies fastest. Other axes have their first value.
        """
        scene = self.scene._replace(effects=self.effects[label])
        parts = Parts(self.materials[label], self.surfaces[label], scene)
        return parts_at(parts, self.grid, axes)

    def force_share(self, label: str) -> float:
        """Return the normal force of a variant relative to the study; 1 without pressures."""
        if not self.pressures:
            return 1.0
        return self.surfaces[label].pressed_area / self.surface.pressed_area

    @property
    def blocks(self) -> int:
        """Number of blocks of realizations, which the jackknife leaves out one at a time."""
        return self.realizations // self.realizations_per_block

    @property
    def rounding(self) -> str:
        """State in words how the realizations of a point were rounded up, or nothing."""
        if self.realizations <= self.realizations_requested:
            return ""
        whole = f"{self.blocks} blocks of {self.realizations_per_block}"
        return f" ({self.realizations_requested} rounded up to {whole})"

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the grid."""
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

    Raises UserError for invalid input: first for all keys, types and ranges, then for
    combinations.

    one_point : whether it is a scene: one point, and possibly a single line. profile : lines in
    place of a table [surface]. scales : tables of the other scales, whose keys are checked too.
    """
    head_keys = ONE_POINT if one_point else STUDY
    given = checked_tables(tables, scales or {}, head_keys)
    cluster = Cluster(**given["cluster"])
    written = {name: table for name, table in tables.items() if name != "cluster"}
    head = study_head(name, folder, written, filled("study", given["study"], head_keys))
    given, several = separated(given)
    choice = choose_body(given, measured=profile is not None or "file" in given["surface"])
    surface = (
        read_surface(
            given["surface"], folder, choice.body, loaded_by_force="normal_force" in given["grid"]
        )
        if profile is None
        else Surface(
            profile.measured_length,
            profile=profile,
            body=HALF_SPACE if profile.heights.ndim > 2 else FOUNDATION,  # a map, or lines
        )
    )
    choice = settle_body(choice, surface, given["grid"])
    variants, materials, surfaces = read_variants(given, folder, surface)
    surface = surfaces[""]
    _check_other_values(given, several, folder, surface)
    effects = read_effects(given["scene"], given["compare"], folder)
    scene = read_scene_table(given["scene"], folder, materials.values())
    scene = scene._replace(effects=effects[""])
    parts = Parts(materials[""], surface, scene)
    grid = read_grid(given["grid"], written.get("grid", {}), parts, several)
    requested = given["study"].get("realizations")
    block = given["study"].get("realizations_per_block")
    if one_point and requested is None:
        requested = head["realizations"]
    head |= _lines_in_blocks(requested, block, surfaces)
    surfaces = {label: _with_block_note(lines, head) for label, lines in surfaces.items()}
    single_line = one_point and head["realizations"] == 1 and not scene.listed
    check_quantities(scene, materials, single_line)
    check_variants(scene, variants, materials, surfaces, effects)
    for axis, values in grid.items() if one_point else ():
        if len(values) > 1 and axis not in PROGRAMME_AXES:
            raise UserError(f"grid.{axis} = {list(values)!r:.40}: must be one value in a scene")
    return Study(
        **head,
        grid=grid,
        scene=scene,
        variants=variants,
        materials=materials,
        surfaces=surfaces,
        effects=effects,
        pressures=given["grid"].get("normal_pressure", ()),
        body_reason=choice.reason + materials[""].depth_in_words,
        cluster=cluster,
    )


def _check_other_values(
    tables: dict[str, dict[str, Any]], several: Grid, folder: Path, surface: Surface
) -> None:
    """Raise UserError for an invalid value of an axis. tables : hold the first values."""
    for axis, (_, *others) in several.items():
        row = ALL_AXES[axis]
        for value in others:
            changed = with_value(tables, row, value)
            if row.table == "surface":
                read_variants(
                    changed, folder, read_surface(changed["surface"], folder, surface.body)
                )
            else:
                read_variants(changed, folder, surface)


def _lines_in_blocks(
    requested: int | None, block: int | None, surfaces: dict[str, Surface]
) -> dict[str, int]:
    """Return the numbers of lines: requested, in all, and per block. Raises UserError.

    requested, block : as written in the study. By default all measured lines are used, and
    correlated neighbours share a block. A single line is its own block.
    """
    profiles = (lines.profile for lines in surfaces.values() if lines.lines == "measured")
    profile = next(filter(None, profiles), None)
    measured = None if profile is None else len(profile.heights)
    if requested is None and measured is None:
        raise UserError("study.realizations: missing")
    if measured is not None and requested is not None and requested > measured:
        count = "1 line was" if measured == 1 else f"{measured} lines were"
        raise UserError(
            f"study.realizations = {requested}: only {count} measured; for more lines set "
            'surface.lines = "random-phase"'
        )
    realizations = requested or measured or 1
    counts = {"realizations_requested": realizations}
    if realizations == 1:
        return counts | {"realizations": 1, "realizations_per_block": 1}
    if block is None and profile is not None and profile.correlation is not None:
        used, size = profile.correlation.whole_blocks(realizations, every=requested is not None)
        return counts | {"realizations": used, "realizations_per_block": size}
    random = any(one.profile is None and one.body == FOUNDATION for one in surfaces.values())
    return counts | _blocks(realizations, block or 1, random)


def _with_block_note(surface: Surface, head: Mapping[str, Any]) -> Surface:
    """Return a surface with a note on its standard errors: none, or from blocks of lines."""
    profile = surface.profile
    if profile is None or surface.lines != "measured":
        return surface
    block, lines = head["realizations_per_block"], head["realizations"]
    if lines == 1:
        note = surface.single_error
    elif profile.correlation is None:
        return surface
    else:
        note = (
            f"neighbouring lines are correlated ({profile.correlation.correlation:.2f}; "
            f"{profile.correlation.lines:.3g} count as one): {lines} in blocks of {block}"
        )
        if block < profile.correlation.lines:
            note += (
                ", too small for reliable standard errors: set "
                f"study.realizations_per_block = {profile.correlation.block}"
            )
    return surface._replace(profile=profile._replace(notes=f"{profile.notes}; {note}"))


def _blocks(realizations: int, block: int, random: bool) -> dict[str, int]:
    """Return the numbers of realizations, in all and per block. Raises UserError.

    random : whether lines are drawn in quartets, so that blocks are rounded up to whole quartets.
    Maps are drawn one by one.
    """
    setting = f"study.realizations_per_block = {block}"
    if realizations % block or realizations // block < 2:
        raise UserError(
            f"{setting}: must divide realizations = {realizations} into at least 2 blocks, from "
            "which standard errors are estimated"
        )
    if random:
        block = QUARTET * math.ceil(block / QUARTET)
        realizations = block * max(2, math.ceil(realizations / block))
    if realizations // block > MAX_BLOCKS:
        raise UserError(
            f"{setting}: divides realizations = {realizations} into "
            f"more than {MAX_BLOCKS} blocks; set it to {-(-realizations // MAX_BLOCKS)} or more"
        )
    return {"realizations": realizations, "realizations_per_block": block}


def study_head(
    name: str, folder: Path, tables: Mapping[str, Any], head: dict[str, Any]
) -> dict[str, Any]:
    """Return the fields of a study that follow from its file and its table [study]."""
    text = json.dumps(tables, indent=1, sort_keys=True, default=str)
    return {"name": name, "folder": folder, "text": text} | head | {"title": head["title"] or name}
