"""What a scene can be asked for: one table for study, plan, reduction and accuracy."""

from typing import NamedTuple

from ...ground import UserError
from ..settings import choice

PROGRAMME, STEP, HELD, SWUNG = "programme", "step", "held", "swung"
FORCE, DASHPOT, ALONE, DRIVEN, PULLED_BY = "force", "dashpot", "alone", "driven", "pulled by"


class Quantity(NamedTuple):
    """One thing a scene can be asked for."""

    effect: str  # what is simulated for it, in words
    means: tuple[str, ...] = ()  # block means that are estimates of it, as the kernels name them
    judged: str = ""  # the estimate whose accuracy can be asked for
    needs: tuple[str, ...] = ()  # other quantities, from one of which it follows
    asks: tuple[str, ...] = ()  # of the scene, see ``why_not``


QUANTITIES = {
    "steady": Quantity(
        "steady sliding at v1 and v2 (no relaxation is marched)",
        ("mu_1", "mu_2", "indentation", "contact_fraction"),
        judged="mu_1",
        asks=(FORCE,),
    ),
    "persson": Quantity(
        "friction and contact area by Persson's theory (closed form)", asks=(FORCE,)
    ),
    "jump": Quantity(
        "jump at t0+ (no relaxation is marched)",
        ("jump",),
        judged="jump",
        asks=(FORCE, STEP, DASHPOT),
    ),
    "relaxation": Quantity(
        "relaxation after the jump (time marching)", judged="relaxation_rate", asks=(FORCE, STEP)
    ),
    "models": Quantity("fits beyond eq. 6 (no further simulation)", needs=("relaxation",)),
    "peak": Quantity(
        "peak of the friction after the velocity step, and its first slope",
        needs=("relaxation", "trace"),
        asks=(FORCE, STEP),
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
        "static peak of the friction after a hold", needs=("trace",), asks=(FORCE, HELD)
    ),
    "rate_state": Quantity(
        "fits of rate-and-state laws: a, b and D_c of Ruina and Dieterich",
        needs=("relaxation", "trace"),
        asks=(FORCE, STEP),
    ),
    "energy": Quantity("energies stored and dissipated, work and their balance", asks=(PROGRAMME,)),
    "contact_lengths": Quantity("distribution of the lengths of contacts", asks=(PROGRAMME,)),
    "snapshots": Quantity("shapes of line and foundation on the way", asks=(ALONE, PROGRAMME)),
    "state": Quantity("state at the end, from which to go on", asks=(ALONE, PROGRAMME)),
}
USUAL = ("steady", "jump", "relaxation")
WITHOUT_DASHPOT = ("steady", "relaxation", "peak")
OF_A_PROGRAMME = ("steady", "trace")
AT_AN_INDENTATION = ("trace",)
OF_A_DRIVE = ("steady", "persson", "trace", "healing", "rate_state", "stick_slip", "slip_events")
OF_ELEMENTS = ("energy", "contact_lengths", "state")


def asked_for(key: str, value: object) -> tuple[str, ...]:
    """Return the quantities of a list in the order of the table. Raises UserError."""
    if not isinstance(value, list) or not value:
        raise UserError(f"{key} = {value!r}: must be a list out of {tuple(QUANTITIES)}")
    for name in value:
        needed = QUANTITIES[choice(key, name, QUANTITIES)].needs
        if needed and not any(other in value for other in needed):
            others = " or ".join(f'"{other}"' for other in needed)
            raise UserError(f'{key} = {value!r}: "{name}" needs {others} too')
    return tuple(name for name in QUANTITIES if name in value)


def judged(quantities: tuple[str, ...]) -> tuple[str, ...]:
    """Return the estimates whose accuracy is asked for with some quantities."""
    return tuple(QUANTITIES[q].judged for q in quantities if QUANTITIES[q].judged)
