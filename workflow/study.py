"""The study: everything a user says in study.toml, checked once and then immutable."""

from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from workflow.place import HERE, Place

AXES = ("hurst", "normal_force", "spacing", "roughness", "velocity", "velocity_step")
QUANTITIES = ("steady", "jump", "relaxation", "models")
DEFAULT_QUANTITIES = QUANTITIES[:3]


@dataclass(frozen=True)
class Numerics:
    """How problems are discretised; ``steps_per_spacing = None`` stands for "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # wanted relative error of what is asked for
    max_realizations: int = 10_000  # per point, on the way to the accuracy


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
    place: Place = HERE  # no part of the results' identity

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


@dataclass(frozen=True)
class Measured:
    """A checked measured study: no grid; its measure.py says what is measured (measured.py)."""

    name: str
    folder: Path  # where study.toml, measure.py and figure.py are
    text: str  # the settings in force, after scale and --set, as JSON
    title: str
    seed: int
    settings: dict[str, object]  # of the table [measure]
    script: ModuleType  # measure.py
