"""The table [material]: a relaxation modulus G(t) = G + sum_b g_b exp(-t/t_b), with a dashpot.

G is the relaxed modulus, each branch (g_b, t_b) a Maxwell element beside it, and the dashpot of
viscosity G relaxation_time acts on rates at once. Without branches it is the Kelvin element. All
times shift with the temperature by one factor a_T (Williams, Landel and Ferry 1955,
doi:10.1021/ja01619a008): log10 a_T = -c1 (T - T_ref)/(c2 + T - T_ref).
"""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ....kernels.rheology.spectrum import Spectrum
from ...errors import UserError
from ..settings import (
    POSITIVE,
    Key,
    as_text,
    filled,
    number,
    pair,
    positive,
    read_table,
    within,
)
from .branches import read_branches

MOST_BRANCHES = 200
RATIOS = (1e-9, 1e9)  # of the modulus of a branch to the relaxed one
TIMES = (1e-30, 1e30)  # s, of a branch
ALIKE = 1e-12  # relative; times closer than this are one
MOST_SHIFT = 30.0  # decades
KELVIN = 230.0  # degrees above the reference: 0 °C in K is 273 above itself
WLF = {
    "c1": Key(
        positive,
        "The first constant of the shift, in decades.",
        "Doubled, times shift by twice as many decades.",
    ),
    "c2": Key(
        positive,
        "The second constant of the shift.",
        "Doubled, times depend half as strongly on the temperature near the reference.",
        "K",
    ),
    "reference": Key(
        number,
        "The temperature at which relaxation times are those that are given.",
        "Raised by ten degrees, all curves are those that were found ten degrees lower; to double "
        "degrees Celsius means nothing.",
        "°C",
    ),
}

Branch = tuple[float, float]  # modulus (Pa), time (s)


class Wlf(NamedTuple):
    """Constants of the shift with temperature."""

    c1: float
    c2: float  # °C
    reference: float  # °C

    def decades(self, temperature: float) -> float:
        """Return log10 a_T at a temperature (°C) above reference - c2."""
        above = temperature - self.reference
        return -self.c1 * above / (self.c2 + above)


class Material(NamedTuple):
    """The elastomer, in SI units; times of dashpot and branches are those at the reference."""

    shear_modulus: float  # Pa, relaxed
    relaxation_time: float = 0.0  # s, of the dashpot beside it; 0: no dashpot
    branches: tuple[Branch, ...] = ()  # times ascending, each once
    wlf: Wlf | None = None
    temperature: float | None = None  # °C, with wlf
    poisson: float = 0.5  # Poisson's ratio, the same at all times
    told: str = ""  # what its branches were read from

    @property
    def contact_modulus(self) -> float:
        """Return the relaxed E* = 2 G/(1 - nu) (Pa), 4 G where the elastomer is incompressible."""
        return 2.0 * self.shear_modulus / (1.0 - self.poisson)

    @property
    def tau(self) -> float:
        """Return the time scale (s): relaxation_time + sum_b g_b t_b / G, times shifted."""
        branches = sum(g * t for g, t in self.branches) / self.shear_modulus
        return (self.relaxation_time + branches) * self.own_shift

    @property
    def at_reference(self) -> "Material":
        """Return the material at the temperature at which its times are given."""
        return self._replace(temperature=None)

    @property
    def longest_time(self) -> float:
        """Return the longest of the times of branches and dashpot (s): how far memory reaches."""
        return self.own_shift * max([self.relaxation_time, *(time for _, time in self.branches)])

    @property
    def jumps(self) -> bool:
        """Return whether forces jump with the velocity: whether there is a dashpot."""
        return self.relaxation_time > 0.0

    def shift(self, temperature: float) -> float:
        """Return a_T, by which all times are longer at a temperature (°C); 1 without WLF."""
        return 10.0 ** self.wlf.decades(temperature) if self.wlf else 1.0

    @property
    def own_shift(self) -> float:
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
    wlf, temperature = given["wlf"], given["temperature"]
    _check_temperature(where, wlf, temperature)
    every = modulus, time or 0.0, _merged(branches), wlf, temperature
    return Material(*every, given["poisson"], told)


def _check_temperature(where: str, wlf: Wlf | None, value: float | None) -> None:
    """Raise UserError for a temperature that has no shift, and for one without the other."""
    if wlf is None or value is None:
        if wlf is not None or value is not None:
            missing, other = ("temperature", "wlf") if value is None else ("wlf", "temperature")
            raise UserError(f"{where}.{missing}: missing; {where}.{other} needs it")
        return
    if value - wlf.reference > KELVIN:
        raise UserError(
            f"{where}.temperature = {value!r}: is {value - wlf.reference:g} degrees above the "
            f"reference, {wlf.reference:g}: is it in K? Give both in °C"
        )
    least = wlf.reference - wlf.c2
    if value <= least:
        raise UserError(
            f"{where}.temperature = {value!r}: must be above reference - c2 = {least:g}, where "
            "the WLF shift has its pole"
        )
    if not abs(wlf.decades(value)) <= MOST_SHIFT:
        raise UserError(
            f"{where}.temperature = {value!r}: shifts times by {wlf.decades(value):.3g} decades, "
            f"but at most {MOST_SHIFT:g} are supported"
        )


def _branches(key: str, value: object) -> tuple[Branch, ...]:
    if not isinstance(value, list) or len(value) > MOST_BRANCHES:
        raise UserError(
            f"{key} = {value!r:.60}: must be a list of [modulus, time], {MOST_BRANCHES} at most"
        )
    return tuple(_branch(f"{key}[{i}]", entry) for i, entry in enumerate(value))


def _branch(key: str, entry: object) -> Branch:
    if not isinstance(entry, list) or len(entry) != 2:
        raise UserError(f"{key} = {entry!r:.60}: must be [modulus in Pa, time in s]")
    return positive(f"{key}[0]", entry[0]), within(f"{key}[1]", entry[1], *TIMES)


def _merged(branches: tuple[Branch, ...]) -> tuple[Branch, ...]:
    """Return the branches sorted by time, those of equal times as one."""
    found: list[Branch] = []
    for modulus, time in sorted(branches, key=lambda branch: (branch[1], branch[0])):
        if found and time <= found[-1][1] * (1.0 + ALIKE):
            found[-1] = (found[-1][0] + modulus, found[-1][1])
        else:
            found.append((modulus, time))
    return tuple(found)


def _wlf(key: str, value: object) -> Wlf:
    return Wlf(**read_table(key, value, WLF))


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
        usual="none",
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
        usual="none",
    ),
    "wlf": Key(
        _wlf,
        "The constants of the shift of Williams, Landel and Ferry, log₁₀ a_T = −c1 (T − "
        "reference)/(c2 + T − reference). All relaxation times are multiplied by a_T. It goes "
        "together with `temperature`.",
        default=None,
        values="`{c1 = …, c2 = …, reference = …}`",
        usual="none",
    ),
    "temperature": Key(
        number,
        "The temperature of the elastomer, with `wlf`.",
        "A higher temperature shortens all times: friction at v is what it was at a_T v. To "
        "double degrees Celsius means nothing.",
        "°C",
        default=None,
        values="a number above `reference` − c2",
        usual="none",
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
