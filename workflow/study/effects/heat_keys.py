"""The table [scene.heat]: properties of the elastomer that friction heats."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ..settings import OPTIONAL, Key, filled, positive, within

MIN_SHARE = 1e-3  # of the heat that enters the elastomer


class HeatProperties(NamedTuple):
    """Heat conduction of the elastomer in SI units."""

    conductivity: float  # W/(m K)
    heat_capacity: float  # J/(m^3 K)
    share: float = 1.0  # of the heat that enters the elastomer
    block: float | None = None  # m; None: no mean heating

    def in_words(self) -> str:
        """Return a description of the properties."""
        block = "no mean heating" if self.block is None else f"a block of {self.block:g} m"
        return (
            f"{self.conductivity:g} W/(m K), {self.heat_capacity:g} J/(m3 K), "
            f"{self.share:g} of the heat enters the rubber, {block}"
        )


def read_heat(where: str, table: Mapping[str, Any], _: Path) -> HeatProperties:
    """Return the properties of the checked values of a table. Raises UserError."""
    return HeatProperties(**filled(where, table, HEAT))


HEAT = {
    "conductivity": Key(
        positive,
        "The thermal conductivity k of the elastomer.",
        "Doubled, the contact warms half as much at slow sliding and 1/√2 times at fast sliding.",
        "W/(m K)",
    ),
    "heat_capacity": Key(
        positive,
        "The heat capacity of the elastomer per volume.",
        "Doubled, the contact warms 1/√2 times as much at fast sliding; at slow sliding it does "
        "not matter.",
        "J/(m³ K)",
    ),
    "share": Key(
        partial(within, least=MIN_SHARE, most=1.0),
        "The share of the heat that enters the surface of the elastomer; the default is an upper "
        "bound.",
        "Doubled, friction of a given size warms twice as much.",
        default=1.0,
    ),
    "block": OPTIONAL(
        positive,
        "The thickness of a block of elastomer whose far side stays at the temperature of the "
        "scene. The mean heat flux warms it, in a programme from its start.",
        "Doubled, the steady mean rise doubles, and takes four times as long.",
        "m",
        usual="none: the mean flux warms nothing, as a half-space has no steady state",
    ),
}
