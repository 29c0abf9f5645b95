"""The table [scene]: what is simulated and how the line is driven and pressed on."""

import math
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from ...ground import UserError
from ..settings import Key, as_text, choice, filled, flag, integer, read_table
from .material import Material
from .programme import (
    FORCE,
    FRESH,
    INDENTATION,
    RELAXED,
    STEADY,
    Programme,
    Scene,
    Spring,
)
from .quantities import QUANTITIES, read_quantities
from .segments import DRIVE, INDENTED, MOST_SEGMENTS, is_pulled, read_programme, read_sampled

FOUNDATION, HALF_SPACE = "foundation", "half-space"
USUAL = Scene()


def read_scene_table(own: Mapping[str, Any], folder: Path, materials: Iterable[Material]) -> Scene:
    """Return the scene of the checked values of a table. Raises UserError.

    own : the programme in it as it is written. Files are found from ``folder``.
    materials : of the study and its comparisons; what is asked for by default depends on them.
    """
    given = filled("scene", own, SCENE)
    del given["body"]  # that of the surfaces (study/variants.py)
    segments, history = given.pop("programme"), given.pop("indentation_file")
    programme = () if segments is None else read_programme("scene.programme", segments, folder)
    drive = _drive(given.pop("drive"), is_pulled("scene.programme", segments or []))
    times, told = None, ""
    if history and given["control"] != INDENTATION:
        raise UserError('scene.indentation_file: needs scene.control = "indentation"')
    if history:
        key = "scene.indentation_file"
        columns, told = read_sampled(key, folder / history, INDENTED)
        times = (tuple(columns[0].tolist()), tuple(columns[1].tolist()))
    asked = given.pop("quantities") or _usual(programme, given["control"], materials)
    scene = Scene(
        quantities=asked,
        programme=programme,
        indentation_history=times,
        indentation_description=told,
        drive=drive,
        **given,
    )
    _check(own, scene, tuple(materials))
    return scene


def _drive(given: dict[str, Any] | None, pulled: bool) -> Spring | None:
    """Return the drive of a programme that pulls. Raises UserError where one lacks the other."""
    if pulled and given is None:
        raise UserError(
            "scene.drive: missing; a programme that pulls needs the stiffness of its spring, as in "
            "[scene.drive] stiffness = 1e4"
        )
    if given is not None and not pulled:
        raise UserError(
            "scene.drive: belongs to a programme of segments pull = {…}, and there is none"
        )
    return None if given is None else Spring(**given)


def _usual(programme: Programme, control: str, materials: Iterable[Material]) -> tuple[str, ...]:
    """Return what is asked for where nothing is said."""
    if control == INDENTATION:
        return ("trace",)
    if programme:
        return "steady", "trace"
    jumps = all(material.jumps for material in materials)
    return USUAL.quantities if jumps else ("steady", "relaxation", "peak")


def _check(table: Mapping[str, Any], scene: Scene, materials: tuple[Material, ...]) -> None:
    """Raise UserError where the keys of a scene do not go together."""
    for key in ("control", "start", "repeat"):
        if key in table and not scene.programme and getattr(scene, key) != getattr(USUAL, key):
            raise UserError(
                f"scene.{key} = {table[key]!r}: belongs to a programme, and there is no "
                "[[scene.programme]]"
            )
    if scene.repeat * len(scene.programme) > MOST_SEGMENTS:
        raise UserError(
            f"scene.repeat = {scene.repeat}: makes {scene.repeat * len(scene.programme)} segments, "
            f"more than {MOST_SEGMENTS}"
        )
    if not scene.indentation_rate and (scene.programme or any(m.branches for m in materials)):
        raise UserError(
            "scene.indentation_rate = false: eq. 3 as printed is defined for one velocity step of "
            "a Kelvin element alone; leave it out"
        )
    if scene.start == FRESH and any(material.jumps for material in materials):
        raise UserError(
            'scene.start = "fresh": a dashpot would carry any load at no indentation; use '
            '"relaxed", or a material without relaxation_time'
        )
    if scene.drive and scene.control != FORCE:
        raise UserError(
            f"scene.control = {scene.control!r}: a drive pulls under a given normal force; leave "
            "it out"
        )
    if scene.programme and math.isnan(scene.typical_speed):
        raise UserError(
            "scene.programme: never moves; add a slide, a ramp or an oscillation, or a pull"
        )
    if scene.programme and scene.start == STEADY and scene.start_velocity(1.0) == 0.0:
        raise UserError(
            'scene.start = "steady": the programme begins at velocity 0, where nothing is steady '
            'sliding; use "relaxed"'
        )


SCENE = {
    "body": Key(
        partial(choice, known=(FOUNDATION, HALF_SPACE)),
        "What is behind the surface. `foundation` is the paper's row of independent elements on a "
        "line; `half-space` is a deep elastic block on a periodic square of side `surface.length`, "
        "where each pressed point pulls down its neighbours (docs/bodies.md).",
        default=FOUNDATION,
    ),
    "quantities": Key(
        read_quantities,
        "What is computed, by the names of the table below. What is not named is not in the "
        "result either. Steady states and jumps march no relaxation.",
        default=None,
        values="a list of names of quantities",
        usual='`["steady", "jump", "relaxation"]`; without a dashpot `["steady", "relaxation", '
        '"peak"]`; with a programme `["steady", "trace"]`; at a prescribed indentation '
        '`["trace"]`',
        schema={"type": "array", "minItems": 1, "items": {"enum": list(QUANTITIES)}},
    ),
    "indentation_rate": Key(
        flag,
        "Whether the rate ḋ of the indentation enters the force of an element. `false` is eq. 3 "
        "as the paper prints it, without physical relaxation; it is there for comparison, for one "
        "velocity step of Kelvin elements alone.",
        default=True,
    ),
    "control": Key(
        partial(choice, known=(FORCE, INDENTATION)),
        "What presses line and elastomer together: a constant normal force, or in a programme a "
        "given indentation, from which the force follows.",
        default=FORCE,
    ),
    "indentation_file": Key(
        as_text,
        "A text file beside `study.toml` with columns time (s) and indentation (m), linear "
        "between the times and constant beyond them, in place of `grid.prescribed_indentation`.",
        default="",
        values="the name of a file",
    ),
    "start": Key(
        partial(choice, known=(STEADY, RELAXED, FRESH)),
        "How a programme begins: in steady sliding at its first velocity, at rest with the "
        "elastomer fully relaxed under the load, or just pressed on, which needs a material "
        "without a dashpot. After a few relaxation times nothing is remembered of it.",
        default=STEADY,
    ),
    "repeat": Key(
        partial(integer, least=1, most=MOST_SEGMENTS),
        "How often the whole programme is followed.",
        "Doubled, the march takes twice as long.",
        default=1,
    ),
    "drive": Key(
        lambda key, value: read_table(key, value, DRIVE),
        "What the line is pulled through by segments `pull`, whose motion is then that of the "
        "drive. The spring begins stretched by steady friction, or slack where the scene does not "
        "begin in steady sliding.",
        default=None,
        values="a table, `[scene.drive]`",
        usual="none: the programme moves the line itself",
    ),
    "programme": Key(
        lambda _, value: value,
        "The motion of the line, as segments `[[scene.programme]]` that follow one another, in "
        "place of `grid.velocity_step`. Without it there is one velocity step from v₁ to v₂.",
        default=None,
        values="a list of up to 1000 segments: `slide`, `hold`, `ramp`, `oscillate` or `file`, or "
        "all of them `pull`",
    ),
}
