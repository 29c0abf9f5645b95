"""The study: everything a user says in study.toml, checked once and then immutable."""

from dataclasses import dataclass
from pathlib import Path

from workflow.errors import UserError
from workflow.study.checks import _flag, choice
from workflow.study.cluster import HERE, Cluster
from workflow.study.grid import AXES
from workflow.study.numerics import Numerics

QUANTITIES = ("steady", "jump", "relaxation", "models")
DEFAULT_QUANTITIES = QUANTITIES[:3]


@dataclass(frozen=True)
class Scene:
    """What is simulated."""

    quantities: tuple[str, ...] = DEFAULT_QUANTITIES
    indentation_rate: bool = True


@dataclass(frozen=True)
class Study:
    """A checked study in SI units."""

    name: str
    folder: Path  # where study.toml and its figure script are
    text: str  # the settings in force, after scale and --set, as JSON
    title: str
    seed: int
    realizations: int
    realizations_per_block: int
    shear_modulus: float  # Pa
    relaxation_time: float  # s
    length: float  # m
    normalisation: str
    grid: dict[str, tuple[float, ...]]
    scene: Scene
    variants: dict[str, Numerics]  # "" is the study itself, the others are its comparisons
    cluster: Cluster = HERE  # no part of the results' identity

    @property
    def blocks(self) -> int:
        """Number of blocks of realizations, the units of the jackknife."""
        return self.realizations // self.realizations_per_block

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the six-dimensional grid."""
        return tuple(len(self.grid[axis]) for axis in AXES)

    def elements(self, spacing: float) -> int:
        """Return N = L / dx."""
        return round(self.length / spacing)


def _scene(table: dict) -> Scene:
    asked = table.get("quantities", list(DEFAULT_QUANTITIES))
    if not isinstance(asked, list) or not asked:
        raise UserError(f"scene.quantities = {asked!r}: must be a list out of {QUANTITIES}")
    for quantity in asked:
        choice("scene.quantities", quantity, QUANTITIES)
    if "models" in asked and "relaxation" not in asked:
        raise UserError(f'scene.quantities = {asked!r}: "models" needs "relaxation" too')
    return Scene(
        quantities=tuple(q for q in QUANTITIES if q in asked),
        indentation_rate=_flag("scene.indentation_rate", table, True),
    )
