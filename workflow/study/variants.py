"""Variants of a study: itself and its comparisons [compare.NAME]."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..ground import UserError
from .effects import (
    EFFECT_TABLES,
    ELEMENT_QUANTITIES,
    FORCE,
    FOUNDATION,
    HALF_SPACE,
    MATERIAL,
    SCENE,
    SHIFTS,
    Material,
    Scene,
    SceneEffects,
    check_effects,
    compared_effect_key,
    read_material,
)
from .numerics import DEFAULTS, NUMERICS, Numerics, read_numerics
from .surfaces import LINE_KIND_KEYS, Surface, lines_like

# Not the temperature: it is an axis of the grid, which all variants share.
COMPARE = NUMERICS | {key: MATERIAL[key] for key in MATERIAL if key != "temperature"}
COMPARE |= LINE_KIND_KEYS | {"body": SCENE["body"]}
COMPARE |= {name: compared_effect_key(SCENE[name]) for name in EFFECT_TABLES}
MIN_LAYER_SHARE = 1e-3  # thickness over the period; thinner layers lose digits of stiffness
ALTERNATIVES = (("branches", "branches_file"), tuple(SHIFTS))  # keys of a group exclude each other


def read_variants(
    tables: Mapping[str, dict[str, Any]], folder: Path, surface: Surface
) -> tuple[dict[str, Numerics], dict[str, Material], dict[str, Surface]]:
    """Return numerics, material and surface by label, for the study ("") and its comparisons.

    tables : checked values. folder : of the files. surface : that of the study. Raises UserError.
    """
    numerics, material = tables["numerics"], tables["material"]
    variants = {"": read_numerics("numerics", numerics)}
    materials = {"": read_material("material", material, folder)}
    body, surfaces = surface.body, {"": surface}
    for label, given in tables["compare"].items():
        where = f"compare.{label}"
        if not re.fullmatch(r"[A-Za-z]\w*", label):
            raise UserError(f'compare."{label}": must be named by letters, digits and underscores')
        changed = {key: given[key] for key in given if key in NUMERICS}
        variants[label] = read_numerics(where, {**numerics, **changed})
        materials[label] = read_material(where, changed_material(material, given), folder)
        like = {key: given[key] for key in given if key in LINE_KIND_KEYS}
        other_body = given.get("body", body)
        if other_body != body and surface.profile is not None:
            raise UserError(
                f"{where}.body = {other_body!r}: measured lines or maps are read for one body; "
                "compute the other one in a study of its own"
            )
        surfaces[label] = lines_like(where, surface, like)._replace(body=other_body)
    return variants, materials, surfaces


def changed_material(material: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the table [material] with the changes of a comparison."""
    replaced = {key for group in ALTERNATIVES if set(group) & given.keys() for key in group}
    unchanged = {key: value for key, value in material.items() if key not in replaced}
    return unchanged | {key: given[key] for key in given if key in MATERIAL}


def check_variants(
    scene: Scene,
    variants: Mapping[str, Numerics],
    materials: Mapping[str, Material],
    surfaces: Mapping[str, Surface],
    effects: Mapping[str, SceneEffects],
) -> None:
    """Raise UserError for keys that the body, the material or an effect does not support."""
    if any(surface.body != FOUNDATION for surface in surfaces.values()):
        _check_half_space(scene)
    for label, surface in surfaces.items():
        of_scene, of_material, of_numerics = (
            f"compare.{label}" if label else table for table in ("scene", "material", "numerics")
        )
        material, heat = materials[label], effects[label].heat
        _check_layer(of_material, material, surface)
        check_effects(of_scene, effects[label], material, scene.rests, surface.body != FOUNDATION)
        _check_numerics(of_numerics, variants[label], scene, material, surface, heat is not None)


def _check_half_space(scene: Scene) -> None:
    """Raise UserError for keys of a scene that a half-space does not support."""
    if scene.control != FORCE:
        raise UserError(
            f"scene.control = {scene.control!r}: the indentation of an infinite half-space is not "
            f'defined; use "{FORCE}", or scene.body = "{FOUNDATION}"'
        )
    if not scene.indentation_rate:
        raise UserError(
            "scene.indentation_rate = false: eq. 3 as printed needs the foundation; omit it, or "
            f'set scene.body = "{FOUNDATION}"'
        )
    for name in scene.quantities:
        if name in ELEMENT_QUANTITIES and not (scene.drive and name == "energy"):
            raise UserError(
                f'scene.quantities: "{name}": is not defined on a half-space, which has no '
                f'elements; omit it, or set scene.body = "{FOUNDATION}"'
            )


def _check_layer(where: str, material: Material, surface: Surface) -> None:
    """Raise UserError for a layer of elements, or one so thin that its stiffness loses digits."""
    if material.thickness is None:
        return
    key, least = f"{where}.thickness = {material.thickness:g}", MIN_LAYER_SHARE * surface.length
    if surface.body == FOUNDATION:
        raise UserError(
            f"{key}: the elements of a foundation have no thickness; set scene.body = "
            f'"{HALF_SPACE}", or omit it'
        )
    if material.thickness < least:
        raise UserError(
            f"{key}: must be at least {least:g} m, {MIN_LAYER_SHARE:g} of surface.length"
        )


def _check_numerics(
    where: str,
    numerics: Numerics,
    scene: Scene,
    material: Material,
    surface: Surface,
    heated: bool,
) -> None:
    """Raise UserError for energies with an unsupported scheme, or accuracy without error laws."""
    if "energy" in scene.quantities and numerics.scheme != DEFAULTS.scheme:
        raise UserError(
            f'{where}.scheme = {numerics.scheme!r}: omit it, or omit "energy" from '
            f"scene.quantities, which needs the scheme {DEFAULTS.scheme}"
        )
    if not numerics.accuracy:
        return
    key, of_maps = f"{where}.accuracy = {numerics.accuracy!r}", surface.body != FOUNDATION
    instead = "give steps_per_spacing and study.realizations instead"
    if heated:
        raise UserError(f"{key}: no law predicts the scatter with scene.heat; {instead}")
    bounded = surface.cutoff or (surface.rolloff and not of_maps)
    given = surface.profile is not None or surface.power is not None
    if scene.programme or given or bounded or material.branches:
        raise UserError(
            f"{key}: needs one velocity step of Kelvin elements on self-affine lines or maps; "
            f"{instead}"
        )
    if of_maps and "relaxation" in scene.quantities:
        raise UserError(
            f'{key}: on a half-space it is available for "steady" and "jump", not for '
            '"relaxation", whose scatter follows no known law; omit "relaxation" or give '
            "study.realizations instead"
        )
