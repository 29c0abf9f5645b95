"""The study itself and its comparisons: [numerics], [material], lines and [compare.NAME]."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..ground import UserError
from .effects import (
    FORCE,
    FOUNDATION,
    MATERIAL,
    OF_ELEMENTS,
    SCENE,
    SHIFTS,
    Material,
    Scene,
    read_material,
)
from .numerics import NUMERICS, USUAL, Numerics, read_numerics
from .surfaces import LIKE, Surface, lines_like

# All of a comparison are points of one grid, to which temperatures belong.
COMPARE = NUMERICS | {key: MATERIAL[key] for key in MATERIAL if key != "temperature"}
COMPARE |= LIKE | {"body": SCENE["body"]}
EITHER = (("branches", "branches_file"), tuple(SHIFTS))  # one takes the place of the others


def read_variants(
    tables: Mapping[str, dict[str, Any]], folder: Path, surface: Surface
) -> tuple[dict[str, Numerics], dict[str, Material], dict[str, Surface]]:
    """Return numerics, material and surface by label, of the study ("") and its comparisons.

    tables : their checked values. Files are found from ``folder``; ``surface`` is that of the
    study. Raises UserError.
    """
    numerics, material = tables["numerics"], tables["material"]
    variants = {"": read_numerics("numerics", numerics)}
    materials = {"": read_material("material", material, folder)}
    body = tables["scene"].get("body", FOUNDATION)
    surfaces = {"": surface._replace(body=body)}
    for label, given in tables["compare"].items():
        where = f"compare.{label}"
        if not re.fullmatch(r"[A-Za-z]\w*", label):
            raise UserError(f'compare."{label}": name it by letters, digits and underscores')
        changed = {key: given[key] for key in given if key in NUMERICS}
        variants[label] = read_numerics(where, {**numerics, **changed})
        materials[label] = read_material(where, changed_material(material, given), folder)
        like = {key: given[key] for key in given if key in LIKE}
        own = given.get("body", body)
        if own != body and surface.profile is not None:
            raise UserError(
                f"{where}.body = {own!r}: measured lines or maps are read for one body; give the "
                "other in a study of its own"
            )
        surfaces[label] = lines_like(where, surface, like)._replace(body=own)
    return variants, materials, surfaces


def changed_material(material: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the table [material] with what a comparison changes of it."""
    others = {key for group in EITHER if set(group) & given.keys() for key in group}
    kept = {key: value for key, value in material.items() if key not in others}
    return kept | {key: given[key] for key in given if key in MATERIAL}


def check_bodies(scene: Scene, surfaces: Mapping[str, Surface]) -> None:
    """Raise UserError where a scene is asked for what a half-space does not have."""
    if all(surface.body == FOUNDATION for surface in surfaces.values()):
        return
    if scene.control != FORCE:
        raise UserError(
            f"scene.control = {scene.control!r}: the indentation of an infinite half-space has no "
            f'meaning; use "{FORCE}", or scene.body = "{FOUNDATION}"'
        )
    if not scene.indentation_rate:
        raise UserError(
            "scene.indentation_rate = false: eq. 3 as printed is defined for the foundation alone"
        )
    for name in scene.quantities:
        if name in OF_ELEMENTS:
            raise UserError(
                f'scene.quantities: "{name}": belongs to single elements; a half-space has none'
            )


def check_numerics(
    variants: dict[str, Numerics],
    materials: dict[str, Material],
    scene: Scene,
    surfaces: Mapping[str, Surface],
) -> None:
    """Raise UserError for energies of another scheme, and for an accuracy beyond its laws."""
    for label, numerics in variants.items():
        where = f"compare.{label}" if label else "numerics"
        if "energy" in scene.quantities and numerics.scheme != USUAL.scheme:
            raise UserError(
                f"{where}.scheme = {numerics.scheme!r}: energies are those of {USUAL.scheme} "
                'alone; leave it out, or "energy" out of scene.quantities'
            )
        if not numerics.accuracy:
            continue
        own = surfaces[label]
        of_maps = own.body != FOUNDATION
        others = own.profile is not None or own.cutoff or (own.rolloff and not of_maps)
        if scene.programme or others or materials[label].branches:
            raise UserError(
                f"{where}.accuracy = {numerics.accuracy!r}: holds for one velocity step of Kelvin "
                "elements on self-affine lines or maps; give steps_per_spacing and "
                "study.realizations"
            )
        if of_maps and "relaxation" in scene.quantities:
            raise UserError(
                f"{where}.accuracy = {numerics.accuracy!r}: on a half-space holds for the "
                'quantities "steady" and "jump", as the scatter of relaxations follows no law; '
                'leave "relaxation" out, or give study.realizations in its place'
            )
