"""What a scene can be asked for: one table for study, plan, reduction and accuracy."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

from ...ground import UserError
from ..settings import choice
from .material import Material
from .programme import FORCE, Oscillate, Scene

Materials = Mapping[str, Material]  # of a study ("") and of its comparisons


class Need(NamedTuple):
    """What a quantity asks of a scene."""

    met: Callable[[Scene, bool], bool]  # by a scene, of a single line or not
    otherwise: str  # why there is none of it

    def lacking(self, scene: Scene, _: Materials, alone: bool) -> str:
        """Return why a scene cannot be asked for it, in words; "" where it can."""
        return "" if self.met(scene, alone) else self.otherwise


class Dashpot(NamedTuple):
    """That a material of every variant has a dashpot."""

    def lacking(self, _: Scene, materials: Materials, __: bool) -> str:
        """Return which material has none, in words; "" where all have one."""
        for label, material in materials.items():
            if not material.jumps:
                where = f"compare.{label}" if label else "material"
                return f"{where} has a finite instantaneous modulus: mu does not jump; ask for peak"
        return ""


PRESSED = Need(
    lambda scene, _: scene.control == FORCE,
    'is defined at a given normal force; with scene.control = "indentation" ask for trace',
)
PROGRAMME = Need(lambda scene, _: bool(scene.programme), "there is no [[scene.programme]]")
STEP = Need(
    lambda scene, _: not scene.programme or bool(scene.velocity_steps),
    "the programme has no velocity step, which is one slide after another at another velocity of "
    "the same sign",
)
HELD = Need(lambda scene, _: scene.heals, "the programme has no hold between two slides")
SWUNG = Need(
    lambda scene, _: any(isinstance(segment, Oscillate) for segment in scene.programme),
    "the programme has no oscillation",
)
PULLED_BY = Need(
    lambda scene, _: scene.drive is not None,
    "nothing is pulled; give [scene.drive] and a programme of segments pull",
)
ALONE = Need(
    lambda _, alone: alone,
    "is there for a single line alone, from workflow.scene or the command animate",
)


class Quantity(NamedTuple):
    """One thing a scene can be asked for."""

    effect: str  # what is simulated for it, in words
    means: tuple[str, ...] = ()  # block means that are estimates of it, as the kernels name them
    judged: str = ""  # the estimate whose accuracy can be asked for
    needs: tuple[str, ...] = ()  # other quantities, from one of which it follows
    asks: tuple[Need | Dashpot, ...] = ()  # of the scene


QUANTITIES = {
    "steady": Quantity(
        "steady sliding at v1 and v2 (no relaxation is marched)",
        ("mu_1", "mu_2", "indentation", "contact_fraction"),
        judged="mu_1",
        asks=(PRESSED,),
    ),
    "persson": Quantity(
        "friction and contact area by Persson's theory (closed form)", asks=(PRESSED,)
    ),
    "jump": Quantity(
        "jump at t0+ (no relaxation is marched)",
        ("jump",),
        judged="jump",
        asks=(PRESSED, STEP, Dashpot()),
    ),
    "relaxation": Quantity(
        "relaxation after the jump (time marching)", judged="relaxation_rate", asks=(PRESSED, STEP)
    ),
    "models": Quantity("fits beyond eq. 6 (no further simulation)", needs=("relaxation",)),
    "peak": Quantity(
        "peak of the friction after the velocity step, and its first slope",
        needs=("relaxation", "trace"),
        asks=(PRESSED, STEP),
    ),
    "trace": Quantity("friction over time along the programme (time marching)", asks=(PROGRAMME,)),
    "stick_slip": Quantity(
        "stick and slip: swing of the drive's force, period and highest velocity",
        asks=(PULLED_BY,),
    ),
    "slip_events": Quantity(
        "when slips of the line begin and end, and when it turns", asks=(ALONE, PULLED_BY)
    ),
    "loop": Quantity(
        "loops of an oscillation: work, in-phase and quadrature part of the friction",
        needs=("trace",),
        asks=(SWUNG,),
    ),
    "cycle_mean": Quantity(
        "mean friction over the later half of the cycles of an oscillation", asks=(SWUNG,)
    ),
    "healing": Quantity(
        "static peak of the friction after a hold", needs=("trace",), asks=(PRESSED, HELD)
    ),
    "rate_state": Quantity(
        "fits of rate-and-state laws: a, b and D_c of Ruina and Dieterich",
        needs=("relaxation", "trace"),
        asks=(PRESSED, STEP),
    ),
    "energy": Quantity("energies stored and dissipated, work and their balance", asks=(PROGRAMME,)),
    "contact_lengths": Quantity("distribution of the lengths of contacts", asks=(PROGRAMME,)),
    "snapshots": Quantity("shapes of line and foundation on the way", asks=(ALONE, PROGRAMME)),
    "state": Quantity("state at the end, from which to go on", asks=(ALONE, PROGRAMME)),
}
OF_A_DRIVE = ("steady", "persson", "trace", "healing", "rate_state", "stick_slip", "slip_events")
OF_ELEMENTS = ("energy", "contact_lengths", "state")


def read_quantities(key: str, value: object) -> tuple[str, ...]:
    """Return the quantities of a list in the order of the table. Raises UserError."""
    if not isinstance(value, list) or not value:
        raise UserError(f"{key} = {value!r}: must be a list out of {tuple(QUANTITIES)}")
    for name in value:
        needed = QUANTITIES[choice(key, name, QUANTITIES)].needs
        if needed and not any(other in value for other in needed):
            others = " or ".join(f'"{other}"' for other in needed)
            raise UserError(f'{key} = {value!r}: "{name}" needs {others} too')
    return tuple(name for name in QUANTITIES if name in value)


def accuracy_estimates(quantities: tuple[str, ...]) -> tuple[str, ...]:
    """Return the estimates whose accuracy is asked for with some quantities."""
    return tuple(QUANTITIES[q].judged for q in quantities if QUANTITIES[q].judged)


def unavailable_reason(name: str, scene: Scene, materials: Materials, alone: bool) -> str:
    """Return why a scene cannot be asked for a quantity, in words; "" where it can.

    alone : whether it is a single line.
    """
    if scene.drive and name not in OF_A_DRIVE:
        return (
            "is not computed of a line on a spring; ask for trace, stick_slip, slip_events, "
            "healing, steady or rate_state"
        )
    found = (need.lacking(scene, materials, alone) for need in QUANTITIES[name].asks)
    return next(filter(None, found), "")


def check_quantities(scene: Scene, materials: Materials, alone: bool) -> None:
    """Raise UserError where a scene is asked for what it has not."""
    for name in scene.quantities:
        if reason := unavailable_reason(name, scene, materials, alone):
            raise UserError(f'scene.quantities: "{name}": {reason}')
