"""Quantities of a scene: one table for study, plan, reduction and accuracy."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

from ...ground import UserError
from ..settings import choice
from .material import Material
from .programme import FORCE, Oscillate, Scene

Materials = Mapping[str, Material]  # by label: "" is the study, others are comparisons


# (scene, materials, whether there is a single line) -> reason why a quantity is unavailable, or "".
Requirement = Callable[[Scene, Materials, bool], str]


def _required(is_met: Callable[[Scene, bool], bool], reason: str) -> Requirement:
    """Return the requirement that ``is_met(scene, single_line)`` is true."""
    return lambda scene, _, single_line: "" if is_met(scene, single_line) else reason


def _jump(scene: Scene, materials: Materials, _: bool) -> str:
    """Return a message that names a material without dashpot and shear, or ""."""
    for label, material in materials.items():
        if not (material.jumps or scene.effects.shear):
            where = f"compare.{label}" if label else "material"
            return f"{where} has no dashpot: mu does not jump; request peak instead"
    return ""


CONSTANT_FORCE = _required(
    lambda scene, _: scene.control == FORCE,
    'needs a given normal force; with scene.control = "indentation" request trace',
)
MOTION = _required(
    lambda scene, _: scene.moves,
    "needs motion, but the programme only holds; request trace, or add a slide",
)
PROGRAMME = _required(lambda scene, _: bool(scene.programme), "needs a [[scene.programme]]")
VELOCITY_STEP = _required(
    lambda scene, _: not scene.programme or bool(scene.velocity_steps),
    "needs a velocity step: two successive slides at different velocities of the same sign",
)
HEALING_HOLD = _required(lambda scene, _: scene.heals, "needs a hold between two slides")
OSCILLATION = _required(
    lambda scene, _: any(isinstance(segment, Oscillate) for segment in scene.programme),
    "needs a segment oscillate in the programme",
)
PULLED_LINE = _required(
    lambda scene, _: scene.drive is not None,
    "needs [scene.drive] and a programme of segments pull",
)
SINGLE_LINE = _required(
    lambda _, single_line: single_line,
    "needs a single line, from workflow.scene or the command animate",
)


class Quantity(NamedTuple):
    """A quantity that a scene can compute."""

    effect: str  # description of the computation
    means: tuple[str, ...] = ()  # names of its block means in the kernels
    accuracy_estimate: str = ""  # the estimate to which a requested accuracy applies
    needs: tuple[str, ...] = ()  # other quantities; at least one must be requested too
    requirements: tuple[Requirement, ...] = ()


QUANTITIES = {
    "steady": Quantity(
        "steady sliding at v1 and v2",
        ("mu_1", "mu_2", "indentation", "contact_fraction"),
        accuracy_estimate="mu_1",
        requirements=(CONSTANT_FORCE, MOTION),
    ),
    "persson": Quantity(
        "friction and contact area by Persson's theory",
        requirements=(CONSTANT_FORCE, MOTION),
    ),
    "model_ratio": Quantity(
        "steady friction on the other body too: the error of the model",
        needs=("steady",),
        requirements=(CONSTANT_FORCE, MOTION),
    ),
    "jump": Quantity(
        "jump at t0+",
        ("jump",),
        accuracy_estimate="jump",
        requirements=(CONSTANT_FORCE, VELOCITY_STEP, _jump),
    ),
    "relaxation": Quantity(
        "relaxation after the jump",
        accuracy_estimate="relaxation_rate",
        requirements=(CONSTANT_FORCE, VELOCITY_STEP),
    ),
    "models": Quantity("fits beyond eq. 6", needs=("relaxation",)),
    "peak": Quantity(
        "peak of the friction after the velocity step, and its first slope",
        needs=("relaxation", "trace"),
        requirements=(CONSTANT_FORCE, VELOCITY_STEP),
    ),
    "trace": Quantity("friction over time along the programme", requirements=(PROGRAMME,)),
    "stick_slip": Quantity(
        "stick-slip: amplitude of the drive's force, period and highest velocity",
        requirements=(PULLED_LINE,),
    ),
    "slip_events": Quantity(
        "times at which slips of the line begin and end, and at which it reverses",
        requirements=(SINGLE_LINE, PULLED_LINE),
    ),
    "loop": Quantity(
        "loops of an oscillation: work, in-phase and quadrature part of the friction",
        needs=("trace",),
        requirements=(OSCILLATION,),
    ),
    "cycle_mean": Quantity(
        "mean friction over the later half of the cycles of an oscillation",
        requirements=(OSCILLATION,),
    ),
    "healing": Quantity(
        "static peak of the friction after a hold",
        needs=("trace",),
        requirements=(CONSTANT_FORCE, HEALING_HOLD),
    ),
    "rate_state": Quantity(
        "fits of rate-and-state laws: a, b and D_c of Ruina and Dieterich",
        needs=("relaxation", "trace"),
        requirements=(CONSTANT_FORCE, VELOCITY_STEP),
    ),
    "energy": Quantity(
        "energies stored and dissipated, work and their balance", requirements=(PROGRAMME,)
    ),
    "contact_lengths": Quantity(
        "distribution of the lengths of contacts", requirements=(PROGRAMME,)
    ),
    "snapshots": Quantity(
        "shapes of line and foundation during the motion", requirements=(SINGLE_LINE, PROGRAMME)
    ),
    "state": Quantity(
        "final state, from which another scene can continue", requirements=(SINGLE_LINE, PROGRAMME)
    ),
}
DRIVE_QUANTITIES = (
    "steady",
    "persson",
    "model_ratio",
    "trace",
    "healing",
    "rate_state",
    "stick_slip",
    "slip_events",
    "energy",
)
ELEMENT_QUANTITIES = ("energy", "contact_lengths", "state")


def read_quantities(key: str, value: object) -> tuple[str, ...]:
    """Return the requested quantities in the order of the table. Raises UserError."""
    if not isinstance(value, list) or not value:
        raise UserError(f"{key} = {value!r}: must be a list of names from {tuple(QUANTITIES)}")
    for name in value:
        needed = QUANTITIES[choice(key, name, QUANTITIES)].needs
        if needed and not any(other in value for other in needed):
            others = " or ".join(f'"{other}"' for other in needed)
            raise UserError(f'{key} = {value!r}: "{name}" needs {others} too')
    return tuple(name for name in QUANTITIES if name in value)


def accuracy_estimates(quantities: tuple[str, ...]) -> tuple[str, ...]:
    """Return the estimates to which a requested accuracy applies."""
    return tuple(filter(None, (QUANTITIES[name].accuracy_estimate for name in quantities)))


def unavailable_reason(name: str, scene: Scene, materials: Materials, single_line: bool) -> str:
    """Return the reason why a quantity is unavailable in a scene, or ""."""
    if scene.drive and name not in DRIVE_QUANTITIES:
        return (
            "is not available for a line on a spring; request trace, stick_slip, slip_events, "
            "energy, healing, steady or rate_state"
        )
    checks = QUANTITIES[name].requirements
    reasons = (check(scene, materials, single_line) for check in checks)
    return next(filter(None, reasons), "")


def check_quantities(scene: Scene, materials: Materials, single_line: bool) -> None:
    """Raise UserError for a requested quantity that is unavailable."""
    for name in scene.quantities:
        if reason := unavailable_reason(name, scene, materials, single_line):
            raise UserError(f'scene.quantities: "{name}": {reason}')
