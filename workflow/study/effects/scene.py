"""The table [scene]: what is simulated and how the line is driven and pressed on."""

import math
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ...ground import UserError
from ..settings import Key, as_text, choice, filled, flag, integer, read_table
from .body_key import BODY
from .drive_keys import DRIVE, Spring
from .material import Material
from .programme import (
    FromFile,
    HoldSegment,
    Oscillate,
    Programme,
    Segment,
    first_speed,
    first_velocity,
    holds,
    is_relative,
    listed_values,
    velocity_steps,
)
from .quantities import (
    ALONE,
    AT_AN_INDENTATION,
    DASHPOT,
    DRIVEN,
    FORCE,
    HELD,
    OF_A_DRIVE,
    OF_A_PROGRAMME,
    PROGRAMME,
    PULLED_BY,
    QUANTITIES,
    STEP,
    SWUNG,
    USUAL,
    WITHOUT_DASHPOT,
    asked_for,
)
from .segments import INDENTED, MOST_SEGMENTS, is_pulled, read_programme, read_sampled

INDENTATION = "indentation"  # a control; the other is by FORCE
STEADY, RELAXED, FRESH = "steady", "relaxed", "fresh"  # starts
History = tuple[tuple[float, ...], tuple[float, ...]]  # times (s), values


class Scene(NamedTuple):
    """What is simulated."""

    quantities: tuple[str, ...] = USUAL
    indentation_rate: bool = True
    control: str = FORCE
    start: str = STEADY  # of a programme
    repeat: int = 1  # times that the whole list is followed
    programme: Programme = ()  # empty: steady at v1, a jump to v2, relaxation
    indentation_history: History | None = None  # d(t) (s, m), constant beyond its ends
    drive: Spring | None = None  # through which the programme pulls; None: it moves the line
    indentation_told: str = ""  # what it was read from

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Return the programme with its repetitions."""
        return self.programme * self.repeat

    @property
    def sampled(self) -> tuple[str, ...]:
        """Return what the sampled velocities of the programme were read as, each once."""
        found = [segment.told for segment in self.programme if isinstance(segment, FromFile)]
        return tuple(dict.fromkeys(found))

    @property
    def slid_before(self) -> bool:
        """Return whether it begins at rest after steady sliding at the velocity of the grid."""
        return (
            self.start == STEADY
            and bool(self.programme)
            and isinstance(self.programme[0], HoldSegment)
        )

    @property
    def takes_velocity(self) -> bool:
        """Return whether the velocity of the grid is used at all."""
        return not self.programme or is_relative(self.programme) or self.slid_before

    @property
    def takes_indentation(self) -> bool:
        """Return whether the grid prescribes the indentation."""
        return self.control == INDENTATION and self.indentation_history is None

    @property
    def listed(self) -> dict[str, tuple[float, ...]]:
        """Return the dimensions of the result whose values its programme gives."""
        return listed_values(self.programme)

    @property
    def typical_speed(self) -> float:
        """Return the speed (m/s) of a programme without the grid's: the first that is not 0."""
        return first_speed(self.programme)

    def start_velocity(self, reference: float) -> float:
        """Return the velocity (m/s) at which it begins where that of the grid is ``reference``."""
        found = first_velocity(self.programme) if self.programme else None
        return found.at(reference) if found else reference


def read_scene_table(own: Mapping[str, Any], folder: Path, materials: Iterable[Material]) -> Scene:
    """Return the scene of the checked values of a table. Raises UserError.

    own : the programme in it as it is written. Files are found from ``folder``.
    materials : of the study and its comparisons; what is asked for by default depends on them.
    """
    given = filled("scene", own, SCENE)
    del given["body"]  # that of the surfaces (study/variants.py)
    segments, history = given.pop("programme"), given.pop("indentation_file")
    programme = () if segments is None else read_programme("scene.programme", segments, folder)
    drive = _drive(given.pop("drive"), is_pulled("scene.programme", segments))
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
        indentation_told=told,
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
        return AT_AN_INDENTATION
    if programme:
        return OF_A_PROGRAMME
    return USUAL if all(material.jumps for material in materials) else WITHOUT_DASHPOT


def _check(table: Mapping[str, Any], scene: Scene, materials: tuple[Material, ...]) -> None:
    """Raise UserError where the keys of a scene do not go together."""
    for key in ("control", "start", "repeat"):
        if key in table and not scene.programme and getattr(scene, key) != USUAL_SCENE[key]:
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
    "body": BODY,
    "quantities": Key(
        asked_for,
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
USUAL_SCENE = Scene()._asdict()


def why_not(name: str, scene: Scene, materials: Mapping[str, Material], alone: bool) -> str:
    """Return why a scene cannot be asked for a quantity, in words; "" where it can.

    materials : of the study ("") and of its comparisons. alone : whether it is a single line.
    """
    if scene.drive and name not in OF_A_DRIVE:
        return WORDS[DRIVEN]
    for need in QUANTITIES[name].asks:
        if need == DASHPOT:
            found = _without_dashpot(materials)
        else:
            found = "" if _given(need, scene, alone) else WORDS[need]
        if found:
            return found
    return ""


def check_quantities(scene: Scene, materials: Mapping[str, Material], alone: bool) -> None:
    """Raise UserError where a scene is asked for what it has not."""
    for name in scene.quantities:
        reason = why_not(name, scene, materials, alone)
        if reason:
            raise UserError(f'scene.quantities: "{name}": {reason}')


def _without_dashpot(materials: Mapping[str, Material]) -> str:
    for label, material in materials.items():
        if not material.jumps:
            where = f"compare.{label}" if label else "material"
            return f"{where} has a finite instantaneous modulus: mu does not jump; ask for peak"
    return ""


def _given(need: str, scene: Scene, alone: bool) -> bool:
    programme = scene.segments
    return {
        PROGRAMME: bool(programme),
        PULLED_BY: scene.drive is not None,
        STEP: not programme or bool(velocity_steps(programme)),
        HELD: bool(holds(programme)),
        SWUNG: any(isinstance(segment, Oscillate) for segment in programme),
        FORCE: scene.control == FORCE,
        ALONE: alone,
    }[need]


WORDS = {
    PROGRAMME: "there is no [[scene.programme]]",
    PULLED_BY: "nothing is pulled; give [scene.drive] and a programme of segments pull",
    DRIVEN: "is not computed of a line on a spring; ask for trace, stick_slip, slip_events, "
    "healing, steady or rate_state",
    STEP: "the programme has no velocity step, which is one slide after another at another "
    "velocity of the same sign",
    HELD: "the programme has no hold between two slides",
    SWUNG: "the programme has no oscillation",
    FORCE: 'is defined at a given normal force; with scene.control = "indentation" ask for trace',
    ALONE: "is there for a single line alone, from workflow.scene or the command animate",
}
