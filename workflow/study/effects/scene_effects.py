"""Effects of a scene besides the loss of the elastomer, for the study and each comparison."""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ...ground import UserError
from ..settings import Key, checked, schema_of
from .heat_keys import HEAT, HeatProperties, read_heat
from .material import Material
from .shearing import SHEAR, Shear, read_shear


class SceneEffects(NamedTuple):
    """Effects of a scene in SI units; an effect that is not requested is None."""

    shear: Shear | None = None
    heat: HeatProperties | None = None


# Table in [scene] -> its keys, and the function (where, checked values, folder) that reads it.
EffectReader = Callable[[str, Mapping[str, Any], Path], Any]
EFFECT_TABLES: dict[str, tuple[Mapping[str, Key], EffectReader]] = {
    "shear": (SHEAR, read_shear),
    "heat": (HEAT, read_heat),
}


def effect_key(name: str, means: str) -> Key:
    """Return the key of an effect table in [scene]."""
    check = partial(checked, keys=EFFECT_TABLES[name][0])
    return Key(check, means, default=None, values=f"a table, `[scene.{name}]`")


def compared_effect_key(key: Key) -> Key:
    """Return the key of an effect table in a comparison, which may also be false: no effect."""
    return Key(
        lambda name, value: None if value is False else key.check(name, value),
        f"{key.means} In a comparison, false: none.",
        schema={"anyOf": [schema_of(key), {"const": False}]},
    )


def read_effects(
    scene: Mapping[str, Any], comparisons: Mapping[str, Mapping[str, Any]], folder: Path
) -> dict[str, SceneEffects]:
    """Return the effects by label, for the study ("") and its comparisons. Raises UserError.

    scene, comparisons : checked values of [scene] and of each [compare.NAME].
    """
    effects = {"": _read("scene", scene, folder)}
    for label, table in comparisons.items():
        changed = _read(f"compare.{label}", table, folder)
        replaced = {name: getattr(changed, name) for name in EFFECT_TABLES if name in table}
        effects[label] = effects[""]._replace(**replaced)
    return effects


def _read(where: str, tables: Mapping[str, Any], folder: Path) -> SceneEffects:
    requested = {name: tables[name] for name in EFFECT_TABLES if tables.get(name) is not None}
    read = {n: EFFECT_TABLES[n][1](f"{where}.{n}", requested[n], folder) for n in requested}
    return SceneEffects(**read)


def check_effects(
    where: str, effects: SceneEffects, material: Material, rests: bool, on_half_space: bool
) -> None:
    """Raise UserError for a missing key, or an effect that material or body do not support.

    where : "scene", or the name of a comparison. rests : whether the surface may be at rest.
    """
    requested = [name for name in EFFECT_TABLES if getattr(effects, name) is not None]
    if requested and not on_half_space:
        raise UserError(
            f"{where}.{requested[0]}: needs the real contact area, which the foundation lacks; set "
            f'scene.body = "half-space", or {where}.{requested[0]} = false in a comparison'
        )
    if effects.heat and material.shift_law is None:
        raise UserError(
            f"{where}.heat: needs relaxation times that shift with the temperature; give "
            "material.wlf, arrhenius or shifts and material.temperature, or omit it"
        )
    shear = effects.shear
    if shear is None or shear.velocity is None:
        return
    if rests and shear.creep_velocity is None:
        raise UserError(
            f"{where}.shear.creep_velocity: missing; a bell vanishes at rest, so that nothing "
            "would stick in a hold or on a spring"
        )
    if material.temperature is not None and shear.activation_energy is None:
        raise UserError(
            f"{where}.shear.activation_energy: missing; the material has a temperature, with which "
            "the bell shifts"
        )
    if material.temperature is None and shear.activation_energy is not None:
        raise UserError(
            f"{where}.shear.activation_energy = {shear.activation_energy:g}: needs "
            "material.temperature; give it, or omit the energy and the reference"
        )
