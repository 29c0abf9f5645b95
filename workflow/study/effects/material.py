"""The table [material]: a relaxation modulus G(t) = G + sum_b g_b exp(-t/t_b) and a dashpot.

G is the relaxed modulus, and each branch (g_b, t_b) is a Maxwell element in parallel. The optional
dashpot has the viscosity G times relaxation_time. Without branches, the material is a Kelvin
element. The temperature multiplies all times by one shift factor a_T (shifting.py).
"""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ....kernels import BACKINGS, Arrhenius, Layer, ShiftLaw, ShiftTable, Spectrum, Wlf
from ...ground import UserError
from ..settings import (
    FILE_NAME,
    OPTIONAL,
    POSITIVE,
    SHIFT_KEYS,
    Key,
    checked,
    choice,
    filled,
    number,
    pair,
    positive,
    two_numbers,
    within,
)
from .branches import read_branches
from .shifting import (
    SHIFTS,
    check_shift,
    read_shift_table,
)

MAX_BRANCHES = 200
MODULUS_RATIO_RANGE = (1e-9, 1e9)  # of a branch to the relaxed modulus
TIME_RANGE = (1e-30, 1e30)  # s, of a branch
TIME_TOLERANCE = 1e-12  # relative; closer times are merged

Branch = tuple[float, float]  # modulus (Pa), time (s)


class Material(NamedTuple):
    """The elastomer in SI units, with times at the reference temperature."""

    shear_modulus: float  # Pa, relaxed
    relaxation_time: float = 0.0  # s, of the dashpot; 0: no dashpot
    branches: tuple[Branch, ...] = ()  # with distinct, ascending times
    wlf: Wlf | None = None
    temperature: float | None = None  # °C, with a shift law
    poisson: float = 0.5  # Poisson's ratio, constant in time
    description: str = ""  # of the file of branches
    arrhenius: Arrhenius | None = None  # in place of wlf
    shifts: ShiftTable | None = None  # in place of wlf
    thickness: float | None = None  # m, of a layer on a rigid base; None: deep
    backing: str = BACKINGS[0]  # of the layer: on its base

    @property
    def contact_modulus(self) -> float:
        """The relaxed E* = 2 G/(1 - nu) (Pa), 4 G for an incompressible elastomer."""
        return 2.0 * self.shear_modulus / (1.0 - self.poisson)

    def layer(self, spacing: float) -> Layer | None:
        """Return the layer in units of the spacing (m), or None for a deep elastomer."""
        if self.thickness is None:
            return None
        return Layer(self.thickness / spacing, self.backing, self.poisson)

    @property
    def depth_in_words(self) -> str:
        """The layer in words, to be appended to a reason; "" for a deep elastomer."""
        if self.thickness is None:
            return ""
        return f"; a layer of {self.thickness:g} m, {self.backing} on a rigid base"

    @property
    def tau(self) -> float:
        """The time scale (s): relaxation_time + sum_b g_b t_b / G, with shifted times."""
        branches = sum(g * t for g, t in self.branches) / self.shear_modulus
        return (self.relaxation_time + branches) * self.shift_factor

    @property
    def at_reference(self) -> "Material":
        """The material at its reference temperature."""
        return self._replace(temperature=None)

    @property
    def jumps(self) -> bool:
        """Return whether forces jump with the velocity, as they do with a dashpot."""
        return self.relaxation_time > 0.0

    @property
    def shift_law(self) -> ShiftLaw | None:
        """The law of the shift with temperature, or None."""
        return self.wlf or self.arrhenius or self.shifts

    def shift(self, temperature: float) -> float:
        """Return the factor a_T of all times at a temperature (°C); 1 without a law."""
        return 10.0 ** self.shift_law.decades(temperature) if self.shift_law else 1.0

    @property
    def shift_factor(self) -> float:
        """The factor a_T at the temperature of the material."""
        return 1.0 if self.temperature is None else self.shift(self.temperature)

    def rheology(self) -> str:
        """Return a description of the elements of the material and their times."""
        if not self.branches:
            return f"Kelvin element, tau = {self.tau:.4g} s"
        number = len(self.branches)
        kind = "standard linear solid" if number == 1 else f"Prony series of {number} branches"
        dashpot = "with a dashpot" if self.jumps else "without a dashpot"
        times = [self.shift_factor * time for _, time in self.branches]
        spread = f"times {min(times):.3g} ... {max(times):.3g} s"
        return f"{kind} {dashpot}, {spread}, tau = {self.tau:.4g} s"

    def spectrum(self) -> Spectrum:
        """Return the spectrum in units of G and tau; it does not depend on the temperature."""
        tau = self.at_reference.tau
        return Spectrum(
            moduli=tuple(modulus / self.shear_modulus for modulus, _ in self.branches),
            times=tuple(time / tau for _, time in self.branches),
            viscosity=self.relaxation_time / tau,
        )


def read_material(where: str, table: Mapping[str, Any], folder: Path) -> Material:
    """Return the material of the checked values of a table. Raises UserError.

    where : name of the table, for messages. folder : folder of the files that the table names.
    """
    values = filled(where, table, MATERIAL)
    branches, description = values["branches"], ""
    if values["branches_file"]:
        if "branches" in table:
            raise UserError(f"{where}.branches_file: give either it or {where}.branches")
        key, path = f"{where}.branches_file", folder / values["branches_file"]
        rows, description = read_branches(key, path, values["shear_modulus"], values["poisson"])
        branches = _branches(key, rows)
    modulus, time = values["shear_modulus"], values["relaxation_time"]
    if not branches and time is None:
        raise UserError(f"{where}.relaxation_time: missing")
    if not branches and time == 0.0:
        raise UserError(f"{where}.relaxation_time = 0.0: must be greater than zero")
    for g, _ in branches:
        if not MODULUS_RATIO_RANGE[0] <= g / modulus <= MODULUS_RATIO_RANGE[1]:
            raise UserError(
                f"{where}.branches: the modulus {g!r} must lie between "
                f"{MODULUS_RATIO_RANGE[0]:g} and {MODULUS_RATIO_RANGE[1]:g} times shear_modulus = "
                f"{modulus!r}"
            )
    if "backing" in table and values["thickness"] is None:
        raise UserError(f"{where}.backing = {values['backing']!r}: needs {where}.thickness")
    shifts = {key: values[key] for key in SHIFT_KEYS}
    if values["shifts_file"]:
        if shifts["shifts"]:
            raise UserError(f"{where}.shifts_file: give either it or {where}.shifts")
        path = folder / values["shifts_file"]
        shifts["shifts"] = read_shift_table(f"{where}.shifts_file", path)
    check_shift(where, shifts, values["temperature"])
    return Material(
        shear_modulus=modulus,
        relaxation_time=time or 0.0,
        branches=_merged(branches),
        temperature=values["temperature"],
        poisson=values["poisson"],
        description=description,
        thickness=values["thickness"],
        backing=values["backing"],
        **shifts,
    )


def shift_law_of(table: Mapping[str, Any]) -> ShiftLaw | None:
    """Return the shift law written in a table [material], or None; shifts_file is not read.

    Raises UserError for an invalid law.
    """
    laws = {key: table[key] for key in SHIFT_KEYS if key in table}
    return next(iter(checked("material", laws, MATERIAL).values()), None)


def shift_of(laws: Mapping[str, Any], temperature: float) -> float:
    """Return a_T at a temperature (°C). laws : keys SHIFT_KEYS of a table with values as written.

    Raises UserError for a temperature out of range.
    """
    table = {"shear_modulus": 1.0, "relaxation_time": 1.0, "temperature": temperature, **laws}
    return read_material("material", checked("material", table, MATERIAL), Path()).shift_factor


def _branches(key: str, value: object) -> tuple[Branch, ...]:
    if not isinstance(value, list) or len(value) > MAX_BRANCHES:
        raise UserError(
            f"{key} = {value!r:.60}: must be a list of up to {MAX_BRANCHES} pairs [modulus, time]"
        )
    words = "[modulus in Pa, time in s]"
    time = partial(within, least=TIME_RANGE[0], most=TIME_RANGE[1])
    return tuple(
        two_numbers(f"{key}[{i}]", entry, words, positive, time) for i, entry in enumerate(value)
    )


def _merged(branches: tuple[Branch, ...]) -> tuple[Branch, ...]:
    """Return the branches sorted by time; branches with equal times are merged."""
    merged: list[Branch] = []
    for modulus, time in sorted(branches, key=lambda branch: (branch[1], branch[0])):
        if merged and time <= merged[-1][1] * (1.0 + TIME_TOLERANCE):
            merged[-1] = (merged[-1][0] + modulus, merged[-1][1])
        else:
            merged.append((modulus, time))
    return tuple(merged)


MATERIAL = {
    "shear_modulus": Key(
        positive,
        "The relaxed (static, long-time) shear modulus G.",
        "Doubled, a Kelvin element behaves as under half the normal force.",
        "Pa",
    ),
    "relaxation_time": OPTIONAL(
        partial(within, least=0.0, most=TIME_RANGE[1]),
        "The relaxation time τ = η/G of a dashpot of viscosity η parallel to the springs. 0 means "
        "no dashpot, and needs branches.",
        "Doubled, friction of a Kelvin element at v equals its former friction at 2v.",
        "s",
        usual="0 with branches, else required",
    ),
    "branches": Key(
        _branches,
        "A Prony series of Maxwell elements in any order: G(t) = G + Σ g_b exp(−t/t_b), with g_b "
        "in Pa and t_b in s.",
        "With all t_b doubled and no dashpot, friction at v equals its former value at 2v.",
        default=(),
        values="a list of `[g_b, t_b]`, 200 at most, g_b from 1e-9 to 1e9 times `shear_modulus`, "
        "t_b from 1e-30 to 1e30",
        schema={
            "type": "array",
            "maxItems": MAX_BRANCHES,
            "items": pair(
                POSITIVE, {"type": "number", "minimum": TIME_RANGE[0], "maximum": TIME_RANGE[1]}
            ),
        },
    ),
    "branches_file": FILE_NAME(
        "A text file beside `study.toml` with columns g_b (Pa) and t_b (s), or as its header "
        "says, in place of `branches`. Shares of G₀ (a column `alpha`, or rows below "
        "`*VISCOELASTIC`) are read too.",
        default="",
    ),
    **SHIFTS,
    "temperature": OPTIONAL(
        number,
        "The temperature of the elastomer, with `wlf`, `arrhenius` or a table of shifts.",
        "Friction at v equals that at a_T v and the reference temperature; doubling degrees "
        "Celsius has no meaning.",
        "°C",
        values="a number above `reference` − c2, or within the table",
    ),
    "poisson": Key(
        partial(within, least=0.0, most=0.5),
        "Poisson's ratio ν. The contact stiffness is E* = 2G/(1−ν), the paper's 4G for an "
        "incompressible elastomer.",
        "Doubled from 0.25 to 0.5, E* rises by half.",
        default=0.5,
    ),
    "thickness": OPTIONAL(
        positive,
        "The thickness of the elastomer on a rigid base, for a half-space only.",
        "Doubled, waves longer than the thickness meet a softer elastomer.",
        "m",
        values="a positive number, at least a thousandth of `surface.length`",
        usual="a deep elastomer",
    ),
    "backing": Key(
        partial(choice, known=BACKINGS),
        "The lower side of the layer: `bonded` to the base, or `free` to slide on it without "
        "friction.",
        default=BACKINGS[0],
    ),
}
