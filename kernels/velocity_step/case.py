"""Input and output of one realization: cases and outcomes, plain data."""

from typing import NamedTuple

import numpy as np

from ..compile.clock import computing_seconds
from ..interface.effects import NO_EFFECTS, Effects
from ..rheology.spectrum import KELVIN, Spectrum

FIRST_STEP = np.array([1])  # kept step of a march, whose mu determines the jump of a stepped case


class Quantities(NamedTuple):
    """Quantities requested from a realization."""

    steady: bool = True
    jump: bool = True
    relaxation: bool = True
    indentation_rate: bool = True  # whether the force includes d' (eq. 3 as printed drops it)
    initial_rate: bool = False  # d mu/dt just after the velocity step
    areas: bool = False  # the real contact of a half-space at v2 and after the velocity step

    @property
    def anything(self) -> bool:
        """Return whether any quantity is requested; each of them needs a steady state."""
        return self.steady or self.jump or self.relaxation or self.initial_rate


class Case(NamedTuple):
    """One load, one speed v1 and the velocity jumps from v1, for any line."""

    load: float  # Fbar = F_N / (4 G L h)
    speed: float  # vbar = v1 tau / dx, signed
    ratios: tuple[float, ...]  # v2 / v1
    kept_steps: tuple[np.ndarray, ...]  # per ratio: the steps at which the relaxation is recorded
    scheme: str
    spectrum: Spectrum = KELVIN
    refine: bool = True  # whether contacts of steady sliding are followed between the samples
    stepped: bool = False  # whether friction of a line is that of its steps (model/realization.py)
    tiles: int = 0  # per side of a map, whose sums are returned; 0: none
    effects: Effects = NO_EFFECTS  # of a half-space

    @property
    def plain(self) -> bool:
        """Return whether the elements are Kelvin elements and never slide backwards."""
        forwards = self.speed > 0.0 and all(ratio > 0.0 for ratio in self.ratios)
        return self.spectrum == KELVIN and forwards


class Seconds(NamedTuple):
    """CPU time of the phases of a case (compile/clock.py), in s. No result depends on it."""

    steady: float
    jump: float
    marching: float


STEADY, JUMP, MARCHING = range(len(Seconds._fields))


class ContactAreas(NamedTuple):
    """Real contact area of a half-space over L^2, for every velocity jump."""

    before: float  # at v1
    after: np.ndarray  # just after the jump, shape (ratios,)
    final: np.ndarray  # in steady sliding at v2, shape (ratios,)
    curves: list[np.ndarray]  # per ratio: at the recorded steps


class HotParts(NamedTuple):
    """Values of a case that friction heats; shear parts of mu in h/dx, 0 without shear."""

    contact_temperature: float  # mean over the contact at v1, °C
    flash_temperature: float  # highest of the surface at v1, °C
    mu_1_shear: float
    mu_2_shear: np.ndarray  # shape (ratios,)
    jump_shear: np.ndarray  # shape (ratios,)
    curve_shear: list[np.ndarray]  # per ratio: at the recorded steps


class Outcome(NamedTuple):
    """Results of a case; mu in h/dx, indentation in h over the mean line."""

    mu_1: float
    indentation: float
    contact_fraction: float
    samples_per_contact: float  # in a march; without one, SteadySliding.effective_samples
    mu_2: np.ndarray  # shape (ratios,)
    jump: np.ndarray  # shape (ratios,)
    curves: list[np.ndarray]  # per ratio: mu at the recorded steps, which tends to mu_2
    work: int  # element updates, the measure of cost
    seconds: Seconds
    initial_rate: np.ndarray  # shape (ratios,): d mu/dt at t0+, per tau; NaN unless requested
    tiles: np.ndarray | None = None  # shape (ratios, sums, tiles, tiles), see half_space/tiles.py
    areas: ContactAreas | None = None
    hot: HotParts | None = None


class PhaseClocks:
    """CPU times of the phases of several cases, which share measured time in proportion to work."""

    def __init__(self, cases: int = 1) -> None:
        self.spent = [[0.0] * cases for _ in Seconds._fields]
        self.last = computing_seconds()

    def lap(self, steady: np.ndarray, jump: np.ndarray | float = 0.0) -> None:
        """Distribute the time since the last reading over steady states and jumps by their work."""
        now = computing_seconds()
        jumps = np.broadcast_to(jump, steady.shape)
        seconds_per_work = (now - self.last) / max(float(steady.sum() + jumps.sum()), 1.0)
        for case in range(steady.size):
            self.spent[STEADY][case] += seconds_per_work * float(steady[case])
            self.spent[JUMP][case] += seconds_per_work * float(jumps[case])
        self.last = now

    def lap_phase(self, phase: int, case: int = 0) -> None:
        """Add the time since the last reading to a phase of one case."""
        now = computing_seconds()
        self.spent[phase][case] += now - self.last
        self.last = now

    def seconds(self, case: int = 0) -> Seconds:
        """Return the CPU times of a case."""
        return Seconds(*[phase[case] for phase in self.spent])
