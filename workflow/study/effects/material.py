"""The table [material]: a relaxation modulus G(t) = G + sum_b g_b exp(-t/t_b), with a dashpot.

G is the relaxed modulus, each branch (g_b, t_b) a Maxwell element beside it, and the dashpot of
viscosity G relaxation_time acts on rates at once. Without branches it is the Kelvin element. All
times shift with the temperature by one factor a_T (shifting.py).
"""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ....kernels.rheology.spectrum import Spectrum
from ...ground import UserError
from ..settings import (
    POSITIVE,
    Key,
    as_text,
    checked,
    filled,
    number,
    pair,
    positive,
    two_numbers,
    within,
)
from .branches import read_branches
from .shifting import (
    SHIFT_KEYS,
    SHIFTS,
    Arrhenius,
    ShiftLaw,
    ShiftTable,
    Wlf,
    check_shift,
    read_shift_table,
)

MOST_BRANCHES = 200
RATIOS = (1e-9, 1e9)  # of the modulus of a branch to the relaxed one
TIMES = (1e-30, 1e30)  # s, of a branch
ALIKE = 1e-12  # relative; times closer than this are one

Branch = tuple[float, float]  # modulus (Pa), time (s)


class Material(NamedTuple):
    """The elastomer, in SI units; times of dashpot and branches are those at the reference."""

    shear_modulus: float  # Pa, relaxed
    relaxation_time: float = 0.0  # s, of the dashpot beside it; 0: no dashpot
    branches: tuple[Branch, ...] = ()  # times ascending, each once
    wlf: Wlf | None = None
    temperature: float | None = None  # °C, with a law of the shift
    poisson: float = 0.5  # Poisson's ratio, the same at all times
    description: str = ""  # what its branches were read from
    arrhenius: Arrhenius | None = None  # in place of wlf
    shifts: ShiftTable | None = None  # in place of wlf

    @property
    def contact_modulus(self) -> float:
        """Return the relaxed E* = 2 G/(1 - nu) (Pa), 4 G where the elastomer is incompressible."""
        return 2.0 * self.shear_modulus / (1.0 - self.poisson)

    @property
    def tau(self) -> float:
        """Return the time scale (s): relaxation_time + sum_b g_b t_b / G, times shifted."""
        branches = sum(g * t for g, t in self.branches) / self.shear_modulus
        return (self.relaxation_time + branches) * self.shift_factor

    @property
    def at_reference(self) -> "Material":
        """Return the material at the temperature at which its times are given."""
        return self._replace(temperature=None)

    @property
    def longest_time(self) -> float:
        """Return the longest of the times of branches and dashpot (s): how far memory reaches."""
        return self.shift_factor * max([self.relaxation_time, *(time for _, time in self.branches)])

    @property
    def jumps(self) -> bool:
        """Return whether forces jump with the velocity: whether there is a dashpot."""
        return self.relaxation_time > 0.0

    @property
    def shift_law(self) -> ShiftLaw | None:
        """Return how its times shift with the temperature; None where they do not."""
        return self.wlf or self.arrhenius or self.shifts

    def shift(self, temperature: float) -> float:
        """Return a_T, by which all times are longer at a temperature (°C); 1 without a law."""
        return 10.0 ** self.shift_law.decades(temperature) if self.shift_law else 1.0

    @property
    def shift_factor(self) -> float:
        """Return a_T at its own temperature."""
        return 1.0 if self.temperature is None else self.shift(self.temperature)

    def spectrum(self) -> Spectrum:
        """Return the material in units of G and tau: the same at all temperatures."""
        tau = self.at_reference.tau
        return Spectrum(
            moduli=tuple(modulus / self.shear_modulus for modulus, _ in self.branches),
            times=tuple(time / tau for _, time in self.branches),
            viscosity=self.relaxation_time / tau,
        )


def read_material(where: str, table: Mapping[str, Any], folder: Path) -> Material:
    """Return the material of the checked values of a table. Raises UserError.

    where : the name of the table, for messages. Files are found from ``folder``.
    """
    given = filled(where, table, MATERIAL)
    branches, told = given["branches"], ""
    if given["branches_file"]:
        if "branches" in table:
            raise UserError(f"{where}.branches_file: give it or {where}.branches, not both")
        key, path = f"{where}.branches_file", folder / given["branches_file"]
        rows, told = read_branches(key, path, given["shear_modulus"], given["poisson"])
        branches = _branches(key, rows)
    modulus, time = given["shear_modulus"], given["relaxation_time"]
    if not branches and time is None:
        raise UserError(f"{where}.relaxation_time: missing")
    if not branches and time == 0.0:
        raise UserError(f"{where}.relaxation_time = 0.0: must be greater than zero")
    for g, _ in branches:
        if not RATIOS[0] <= g / modulus <= RATIOS[1]:
            raise UserError(
                f"{where}.branches: the modulus {g!r} must lie between {RATIOS[0]:g} and "
                f"{RATIOS[1]:g} of shear_modulus = {modulus!r}"
            )
    shifts = {key: given[key] for key in SHIFT_KEYS}
    if given["shifts_file"]:
        if shifts["shifts"]:
            raise UserError(f"{where}.shifts_file: give it or {where}.shifts, not both")
        path = folder / given["shifts_file"]
        shifts["shifts"] = read_shift_table(f"{where}.shifts_file", path)
    check_shift(where, shifts, given["temperature"])
    return Material(
        shear_modulus=modulus,
        relaxation_time=time or 0.0,
        branches=_merged(branches),
        temperature=given["temperature"],
        poisson=given["poisson"],
        description=told,
        **shifts,
    )


def shift_law_of(table: Mapping[str, Any]) -> ShiftLaw | None:
    """Return the shift that stands in a table [material], as written, and not in a file.

    None where there is none. Raises UserError for one that is none.
    """
    laws = {key: table[key] for key in SHIFT_KEYS if key in table}
    return next(iter(checked("material", laws, MATERIAL).values()), None)


def shift_of(laws: Mapping[str, Any], temperature: float) -> float:
    """Return a_T at a temperature (°C); laws : what a table holds of SHIFT_KEYS, as written.

    Raises UserError for a temperature without one.
    """
    table = {"shear_modulus": 1.0, "relaxation_time": 1.0, "temperature": temperature, **laws}
    return read_material("material", checked("material", table, MATERIAL), Path()).shift_factor


def _branches(key: str, value: object) -> tuple[Branch, ...]:
    if not isinstance(value, list) or len(value) > MOST_BRANCHES:
        raise UserError(
            f"{key} = {value!r:.60}: must be a list of [modulus, time], {MOST_BRANCHES} at most"
        )
    words, of_times = "[modulus in Pa, time in s]", partial(within, least=TIMES[0], most=TIMES[1])
    return tuple(
        two_numbers(f"{key}[{i}]", entry, words, positive, of_times)
        for i, entry in enumerate(value)
    )


def _merged(branches: tuple[Branch, ...]) -> tuple[Branch, ...]:
    """Return the branches sorted by time, those of equal times as one."""
    found: list[Branch] = []
    for modulus, time in sorted(branches, key=lambda branch: (branch[1], branch[0])):
        if found and time <= found[-1][1] * (1.0 + ALIKE):
            found[-1] = (found[-1][0] + modulus, found[-1][1])
        else:
            found.append((modulus, time))
    return tuple(found)


MATERIAL = {
    "shear_modulus": Key(
        positive,
        "The relaxed (static, long-time) shear modulus G of the elastomer.",
        "Doubled, a Kelvin element behaves exactly as under half the normal force, since the two "
        "enter as F̄ alone.",
        "Pa",
    ),
    "relaxation_time": Key(
        partial(within, least=0.0, most=TIMES[1]),
        "The relaxation time τ = η/G of the dashpot of viscosity η beside the springs, the only "
        "time of a material without branches. 0 means no dashpot, and needs branches.",
        "Doubled, a Kelvin element at v rubs exactly as it did at 2v, and relaxes in twice the "
        "time.",
        "s",
        default=None,
        usual="0 where there are branches, else required",
    ),
    "branches": Key(
        _branches,
        "A Prony series: Maxwell elements of modulus g_b (Pa) and relaxation time t_b (s), in any "
        "order, so that G(t) = G + Σ g_b exp(−t/t_b).",
        "With all g_b doubled, their instantaneous forces and what they dissipate in a given "
        "motion double. With all t_b doubled and no dashpot, friction at v is what it was at 2v.",
        default=(),
        values="a list of `[g_b, t_b]`, 200 at most, g_b from 1e-9 to 1e9 times `shear_modulus`, "
        "t_b from 1e-30 to 1e30",
        schema={
            "type": "array",
            "maxItems": MOST_BRANCHES,
            "items": pair(POSITIVE, {"type": "number", "minimum": TIMES[0], "maximum": TIMES[1]}),
        },
    ),
    "branches_file": Key(
        as_text,
        "A text file beside `study.toml` with columns g_b (Pa) and t_b (s), or in the order and "
        "units that its header names, in place of `branches`; shares of G₀ (`alpha`, or below "
        "`*VISCOELASTIC`) are read too. The command `prony` writes one from measured moduli.",
        default="",
        values="the name of a file",
    ),
    **SHIFTS,
    "temperature": Key(
        number,
        "The temperature of the elastomer, with `wlf`, `arrhenius` or a table of shifts.",
        "A higher temperature shortens all times: friction at v is what it was at a_T v. To "
        "double degrees Celsius means nothing.",
        "°C",
        default=None,
        values="a number above `reference` − c2, or within the table",
    ),
    "poisson": Key(
        partial(within, least=0.0, most=0.5),
        "Poisson's ratio ν. The stiffness in contact is E* = 2G/(1−ν), which is the paper's 4G for "
        "an incompressible elastomer.",
        "Doubled from 0.25 to 0.5, E* is larger by one half, as if the force were smaller by a "
        "third.",
        default=0.5,
    ),
}
