"""What a scene can be asked for: one table for study, plan, reduction and accuracy."""

from typing import NamedTuple

from workflow.errors import UserError
from workflow.study.checks import choice


class Quantity(NamedTuple):
    """One thing a scene can be asked for."""

    effect: str  # what is simulated for it, in words
    means: tuple[str, ...] = ()  # block means that are estimates of it, as the kernels name them
    judged: str = ""  # the estimate whose accuracy can be asked for
    needs: str = ""  # another quantity that it follows from


QUANTITIES = {
    "steady": Quantity(
        "steady sliding at v1 and v2 (no time marching)",
        ("mu_1", "mu_2", "indentation", "contact_fraction"),
        judged="mu_1",
    ),
    "jump": Quantity("jump at t0+ (no time marching)", ("jump",), judged="jump"),
    "relaxation": Quantity("relaxation after the jump (time marching)", judged="relaxation_rate"),
    "models": Quantity("fits beyond eq. 6 (no further simulation)", needs="relaxation"),
}
USUAL = ("steady", "jump", "relaxation")


def asked_for(key: str, value: object) -> tuple[str, ...]:
    """Return the quantities of a list in the order of the table. Raises UserError."""
    if not isinstance(value, list) or not value:
        raise UserError(f"{key} = {value!r}: must be a list out of {tuple(QUANTITIES)}")
    for name in value:
        needed = QUANTITIES[choice(key, name, QUANTITIES)].needs
        if needed and needed not in value:
            raise UserError(f'{key} = {value!r}: "{name}" needs "{needed}" too')
    return tuple(name for name in QUANTITIES if name in value)


def judged(quantities: tuple[str, ...]) -> tuple[str, ...]:
    """Return the estimates whose accuracy is asked for with some quantities."""
    return tuple(QUANTITIES[q].judged for q in quantities if QUANTITIES[q].judged)
