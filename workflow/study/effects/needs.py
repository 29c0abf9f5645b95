"""What a quantity asks of the scene: one place for what is refused and what `plan` explains."""

from collections.abc import Mapping

from ...errors import UserError
from .material import Material
from .programme import Oscillate, holds, velocity_steps
from .quantities import ALONE, DASHPOT, FORCE, HELD, PROGRAMME, QUANTITIES, STEP, SWUNG
from .scene import FORCE as BY_FORCE
from .scene import Scene


def why_not(name: str, scene: Scene, materials: Mapping[str, Material], alone: bool) -> str:
    """Return why a scene cannot be asked for a quantity, in words; "" where it can.

    materials : of the study ("") and of its comparisons. alone : whether it is a single line.
    """
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
        STEP: not programme or bool(velocity_steps(programme)),
        HELD: bool(holds(programme)),
        SWUNG: any(isinstance(segment, Oscillate) for segment in programme),
        FORCE: scene.control == BY_FORCE,
        ALONE: alone,
    }[need]


WORDS = {
    PROGRAMME: "there is no [[scene.programme]]",
    STEP: "the programme has no velocity step, which is one slide after another at another "
    "velocity of the same sign",
    HELD: "the programme has no hold between two slides",
    SWUNG: "the programme has no oscillation",
    FORCE: 'is defined at a given normal force; with scene.control = "indentation" ask for trace',
    ALONE: "is there for a single line alone, from workflow.scene or the command animate",
}
