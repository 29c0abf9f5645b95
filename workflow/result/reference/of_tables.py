"""Every variable with its declaration and its meaning: what the reference page is made of."""

from collections.abc import Mapping
from typing import NamedTuple

from ..variables import FLAGS, VARIABLES
from . import of_programmes, steps

SECTIONS: dict[str, Mapping[str, str]] = {
    "Every result": steps.GENERAL,
    "Steady sliding (quantity `steady`)": steps.STEADY,
    "The jump (quantity `jump`)": steps.JUMP,
    "Relaxation after the velocity step (quantity `relaxation`)": steps.RELAXATION,
    "Exponents, one for each H (quantity `relaxation`)": steps.EXPONENTS,
    "Fits beyond eq. 6 (quantity `models`)": steps.MODELS,
    "Along a programme (quantity `trace`)": of_programmes.TRACE,
    "Peaks, holds and loops (`peak`, `healing`, `loop`, `cycle_mean`)": of_programmes.EVENTS,
    "Rate and state (quantity `rate_state`)": of_programmes.RATE_STATE,
    "Energy and lengths of contacts (quantities `energy`, `contact_lengths`)": of_programmes.ENERGY,
    "A single line (quantities `snapshots`, `state`)": of_programmes.ALONE,
}


class DescribedVariable(NamedTuple):
    """One variable with all that is said of it."""

    name: str
    units: str
    dims: tuple[str, ...]
    flags: tuple[str, ...]  # meanings of −1, 0, 1 …; empty where it is no flag
    comment: str
    text: str


def described_variables() -> dict[str, tuple[DescribedVariable, ...]]:
    """Return title of a section -> its variables.

    Raises KeyError for a variable without a meaning, and for a meaning without a variable.
    """
    meant = {name for section in SECTIONS.values() for name in section}
    if meant != VARIABLES.keys():
        raise KeyError(f"{sorted(meant ^ VARIABLES.keys())} lack a variable or a meaning")
    return {title: tuple(_described(*each) for each in s.items()) for title, s in SECTIONS.items()}


def _described(name: str, text: str) -> DescribedVariable:
    variable = VARIABLES[name]
    flags = ("failed", *FLAGS[name].split()) if name in FLAGS else ()
    return DescribedVariable(
        name,
        variable.units,
        variable.dims,
        flags,
        variable.comment,
        text,
    )
