"""The table [scene]: requested quantities, motion of the line, load and body."""

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ...ground import UserError
from ..settings import (
    FILE_NAME,
    OPTIONAL,
    Key,
    choice,
    filled,
    flag,
    inline_table,
    integer,
)
from .histories import INDENTATION_COLUMN, read_history
from .material import Material
from .programme import FORCE, FRESH, INDENTATION, RELAXED, STEADY, Scene, Spring
from .quantities import QUANTITIES, read_quantities
from .scene_effects import EFFECT_TABLES, effect_key
from .segment_keys import DRIVE, MAX_SEGMENTS, PROGRAMME_SCHEMA
from .segments import is_pulled, read_programme

FOUNDATION, HALF_SPACE = "foundation", "half-space"
DEFAULT_SCENE = Scene()


def read_scene_table(
    table: Mapping[str, Any], folder: Path, materials: Iterable[Material]
) -> Scene:
    """Return the scene of the checked values of a table. Raises UserError.

    table : values, with the programme unchecked. folder : folder of the files that it names.
    materials : those of the study and its comparisons, which determine the default quantities.
    """
    values = filled("scene", table, SCENE)
    for name in ("body", *EFFECT_TABLES):  # read by variant (study/variants.py)
        del values[name]
    segments, history = values.pop("programme"), values.pop("indentation_file")
    programme = () if segments is None else read_programme(segments, folder)
    drive = _drive(values.pop("drive"), is_pulled(segments or []))
    times, description = None, ""
    if history and values["control"] != INDENTATION:
        raise UserError('scene.indentation_file: needs scene.control = "indentation"')
    if history:
        key = "scene.indentation_file"
        samples, description = read_history(key, folder / history, INDENTATION_COLUMN)
        times = (tuple(samples[0].tolist()), tuple(samples[1].tolist()))
    requested = values.pop("quantities")
    scene = Scene(
        programme=programme,
        indentation_history=times,
        indentation_description=description,
        drive=drive,
        **values,
    )
    scene = scene._replace(quantities=requested or _default_quantities(scene, materials))
    _check(table, scene, tuple(materials))
    return scene


def _drive(values: dict[str, Any] | None, pulled: bool) -> Spring | None:
    """Return the drive, if any. Raises UserError for a drive without pulls, or the reverse."""
    if pulled and values is None:
        raise UserError(
            "scene.drive: missing; segments pull need the stiffness of a spring, for example "
            "[scene.drive] stiffness = 1e4"
        )
    if values is not None and not pulled:
        raise UserError(
            "scene.drive: needs a programme of segments pull = {…}; omit it without one"
        )
    return None if values is None else Spring(**values)


def _default_quantities(scene: Scene, materials: Iterable[Material]) -> tuple[str, ...]:
    """Return the quantities computed by default."""
    if scene.control == INDENTATION or not scene.moves:
        return ("trace",)
    if scene.programme:
        return "steady", "trace"
    jumps = all(material.jumps for material in materials)
    return DEFAULT_SCENE.quantities if jumps else ("steady", "relaxation", "peak")


class Rule(NamedTuple):
    """An invalid combination of keys of a scene, and the message about it."""

    is_broken: Callable[[Scene, tuple[Material, ...]], bool]  # scene, materials of all variants
    message: str  # with placeholders such as {scene.control}


RULES = (
    Rule(
        lambda scene, _: scene.repeat * len(scene.programme) > MAX_SEGMENTS,
        "scene.repeat = {scene.repeat}: makes {segments} segments; must make at most "
        f"{MAX_SEGMENTS}",
    ),
    Rule(
        lambda scene, materials: (
            not scene.indentation_rate
            and (bool(scene.programme) or any(material.branches for material in materials))
        ),
        "scene.indentation_rate = false: eq. 3 as printed holds for one velocity step of a Kelvin "
        "element only; omit it",
    ),
    Rule(
        lambda scene, materials: (
            scene.start == FRESH and any(material.jumps for material in materials)
        ),
        'scene.start = "fresh": a dashpot would carry any load at zero indentation; use "relaxed" '
        "or a material without relaxation_time",
    ),
    Rule(
        lambda scene, _: scene.drive is not None and scene.control != FORCE,
        "scene.control = {scene.control!r}: a drive needs a given normal force; omit it",
    ),
    Rule(
        lambda scene, _: (
            bool(scene.programme) and scene.start == STEADY and scene.start_velocity(1.0) == 0.0
        ),
        'scene.start = "steady": the programme begins at velocity 0, without steady sliding; use '
        '"relaxed"',
    ),
)


def _check(table: Mapping[str, Any], scene: Scene, materials: tuple[Material, ...]) -> None:
    """Raise UserError for an invalid combination of keys."""
    for key in ("control", "start", "repeat"):
        changed = key in table and getattr(scene, key) != getattr(DEFAULT_SCENE, key)
        if changed and not scene.programme:
            raise UserError(
                f"scene.{key} = {table[key]!r}: needs a programme; add [[scene.programme]] or omit "
                "it"
            )
    for rule in RULES:
        if rule.is_broken(scene, materials):
            raise UserError(rule.message.format(scene=scene, segments=len(scene.segments)))


SCENE = {
    "body": OPTIONAL(
        partial(choice, known=(FOUNDATION, HALF_SPACE)),
        "`foundation` is the paper's row of independent elements along a line; `half-space` is a "
        "deep elastic block under a periodic square surface of side `surface.length` "
        "(docs/bodies.md).",
        usual="a half-space for a random surface under `grid.normal_pressure` and for a measured "
        "map whose steps are known both ways, unless `surface.lines` or a prescribed indentation "
        "requests lines; else the foundation",
    ),
    "quantities": OPTIONAL(
        read_quantities,
        "The computed quantities, by the names of the table below. The result contains only these.",
        values="a list of names of quantities",
        usual='`["steady", "jump", "relaxation"]`; without a dashpot `["steady", "relaxation", '
        '"peak"]`; with a programme `["steady", "trace"]`; with a prescribed indentation '
        'or holds only `["trace"]`',
        schema={"type": "array", "minItems": 1, "items": {"enum": list(QUANTITIES)}},
    ),
    "indentation_rate": Key(
        flag,
        "Whether the rate ḋ of the indentation enters the force of an element. `false` gives eq. "
        "3 as printed, without physical relaxation, for one velocity step of Kelvin elements.",
        default=True,
    ),
    "control": Key(
        partial(choice, known=(FORCE, INDENTATION)),
        "The control of the contact: a constant normal force or, in a programme, a given "
        "indentation.",
        default=FORCE,
    ),
    "indentation_file": FILE_NAME(
        "A text file beside `study.toml` with columns time (s) and indentation (m), in place of "
        "`grid.prescribed_indentation`. The indentation is linear between the times and constant "
        "beyond them.",
        default="",
    ),
    "start": Key(
        partial(choice, known=(STEADY, RELAXED, FRESH)),
        "The initial state of a programme: steady sliding at its first velocity, rest with the "
        "elastomer fully relaxed under the load, or rest immediately after loading, which needs a "
        "material without a dashpot.",
        default=STEADY,
    ),
    "repeat": Key(
        partial(integer, least=1, most=MAX_SEGMENTS),
        "The number of times that the programme runs.",
        "Doubled, the march takes twice as long.",
        default=1,
    ),
    "drive": OPTIONAL(
        partial(inline_table, keys=DRIVE),
        "The spring and damper through which a drive pulls the line; segments `pull` move the "
        "drive. Initially the spring carries steady friction, or is slack without steady sliding.",
        values="a table, `[scene.drive]`",
        usual="none: the programme moves the line itself",
    ),
    "shear": effect_key(
        "shear",
        "The shear stress τ_f of the real contact of a half-space. Friction is the viscoelastic "
        "part plus τ_f times the real contact area.",
    ),
    "heat": effect_key(
        "heat",
        "The heat of friction, which warms the contact of a half-space and shortens its "
        "relaxation times (docs/effects.md).",
    ),
    "programme": OPTIONAL(
        lambda _, value: [value] if isinstance(value, dict) else value,
        "The motion as successive segments `[[scene.programme]]`, in place of "
        "`grid.velocity_step`.",
        values="a segment or a list of up to 1000: either `slide`, `hold`, `ramp`, `oscillate` and "
        "`file`, or only `pull`",
        schema=PROGRAMME_SCHEMA,
    ),
}
