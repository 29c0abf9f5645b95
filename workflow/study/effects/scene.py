"""The table [scene]: what is simulated and how the line is driven and pressed on."""

import math
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ...errors import UserError
from ..settings import Key, as_text, choice, filled, flag, integer
from .material import Material
from .programme import (
    HoldSegment,
    Programme,
    Segment,
    first_speed,
    first_velocity,
    hold_durations,
    is_relative,
)
from .quantities import (
    AT_AN_INDENTATION,
    OF_A_PROGRAMME,
    QUANTITIES,
    USUAL,
    WITHOUT_DASHPOT,
    asked_for,
)
from .segments import MOST_SEGMENTS, read_programme, sampled

FORCE, INDENTATION = "force", "indentation"  # controls
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

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Return the programme with its repetitions."""
        return self.programme * self.repeat

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
    def holds(self) -> tuple[float, ...]:
        """Return the durations (s) of the dimension "hold"; none without it."""
        return hold_durations(self.programme)

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
    segments, history = given.pop("programme"), given.pop("indentation_file")
    programme = () if segments is None else read_programme("scene.programme", segments, folder)
    times = None
    if history:
        key = "scene.indentation_file"
        columns = sampled(key, folder / history, "an indentation in m")
        times = (tuple(columns[0].tolist()), tuple(columns[1].tolist()))
    asked = given.pop("quantities") or _usual(programme, given["control"], materials)
    scene = Scene(quantities=asked, programme=programme, indentation_history=times, **given)
    _check(own, scene, tuple(materials))
    return scene


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
    if scene.indentation_history is not None and scene.control != INDENTATION:
        raise UserError('scene.indentation_file: needs scene.control = "indentation"')
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
    if scene.programme and math.isnan(scene.typical_speed):
        raise UserError("scene.programme: never moves; add a slide, a ramp or an oscillation")
    if scene.programme and scene.start == STEADY and scene.start_velocity(1.0) == 0.0:
        raise UserError(
            'scene.start = "steady": the programme begins at velocity 0, where nothing is steady '
            'sliding; use "relaxed"'
        )


SCENE = {
    "quantities": Key(
        asked_for,
        "What is computed. What is not named is neither computed nor in the result file; the "
        "list of names is in the table of quantities below.",
        "Each further name costs what it takes; steady states and jumps need no time marching.",
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
        "of the paper as it is printed, for one velocity step of Kelvin elements alone.",
        "Without it the velocity step has no physical relaxation; it is there for comparison.",
        default=True,
    ),
    "control": Key(
        partial(choice, known=(FORCE, INDENTATION)),
        "What presses line and elastomer together: a constant normal force, or with "
        '`"indentation"` a given indentation, from which the force follows.',
        "A programme is needed for control by indentation.",
        default=FORCE,
    ),
    "indentation_file": Key(
        as_text,
        "A text file beside `study.toml` with the columns time (s) and indentation (m). The "
        "indentation is linear between the times and constant beyond them. It takes the place of "
        "`grid.prescribed_indentation`.",
        "Another file is another history of the indentation.",
        default="",
        values="the name of a file",
        usual="none",
    ),
    "start": Key(
        partial(choice, known=(STEADY, RELAXED, FRESH)),
        "How a programme begins: in steady sliding at its first velocity, at rest with the "
        "elastomer fully relaxed under the load, or just pressed on. The last needs a material "
        "without a dashpot.",
        "It changes the beginning of a trace; after a few relaxation times nothing is remembered "
        "of it.",
        default=STEADY,
    ),
    "repeat": Key(
        partial(integer, least=1, most=MOST_SEGMENTS),
        "How often the whole programme is followed.",
        "Doubled, the march takes twice as long.",
        default=1,
    ),
    "programme": Key(
        lambda _, value: value,
        "The motion of the line, as a list of segments `[[scene.programme]]` that follow one "
        "another. Without it there is one velocity step from v₁ to v₂.",
        "With a programme `grid.velocity_step` is left out.",
        default=None,
        values="a list of up to 1000 segments: `slide`, `hold`, `ramp`, `oscillate` or `file`",
        usual="none",
    ),
}
USUAL_SCENE = Scene()._asdict()
