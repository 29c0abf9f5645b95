"""The table [scene.shear]: shear stress of the real contact over the sliding speed, in SI units.

It is a bell over the logarithm of the speed, a constant, or a measured table (kernels/interface).
"""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ...ground import UserError
from ...text_tables import read_text_table
from ..columns import (
    STRESS_NAME,
    ColumnSpec,
    describe_columns,
    select_columns,
)
from ..row_checks import POSITIVE_NUMBER, check_rows
from ..settings import FILE_NAME, OPTIONAL, filled, number, positive, within

MAX_SHEAR_STRESS = 1e12  # Pa
SHEAR_HEADER_ADVICE = 'a header "velocity [m/s], stress [Pa]"'
SPEED_COLUMN = ColumnSpec(
    "a velocity", "velocity", r"vel|speed|^v([_ ]|$)", "m/s", SHEAR_HEADER_ADVICE
)
STRESS_COLUMN = ColumnSpec(
    "a shear stress", "pressure", rf"{STRESS_NAME}|^(tau|\u03c4)", "Pa", SHEAR_HEADER_ADVICE
)


class Shear(NamedTuple):
    """Shear stress of the real contact; a bell has a velocity, a table has rows."""

    stress: float | None = None  # Pa, the maximum of a bell
    velocity: float | None = None  # m/s, of the maximum
    width: float | None = None  # decades
    creep_velocity: float | None = None  # m/s
    activation_energy: float | None = None  # J/mol
    reference: float | None = None  # °C
    rows: tuple[tuple[float, float], ...] = ()  # speed (m/s), stress (Pa); speeds increasing
    description: str = ""  # of the file

    def in_words(self) -> str:
        """Return a description of the law."""
        if self.rows:
            return f"table over {self.rows[0][0]:g} to {self.rows[-1][0]:g} m/s"
        if self.velocity is None:
            return f"{self.stress:g} Pa at any speed"
        return f"up to {self.stress:g} Pa at {self.velocity:g} m/s, {self.width:g} decades wide"


def read_shear(where: str, table: Mapping[str, Any], folder: Path) -> Shear:
    """Return the law of the checked values of a table. Raises UserError.

    where : name of the table, for messages. folder : folder of the file that it names.
    """
    values = filled(where, table, SHEAR)
    file = values.pop("file")
    if (values["stress"] is None) == (not file):
        raise UserError(
            f"{where}.file: give either it or {where}.stress"
            if file
            else f"{where}.stress: missing; give the shear stress of the real contact in Pa, or a "
            f"table of it over the speed as {where}.file"
        )
    _check_together(where, values, "velocity", "width")
    _check_together(where, values, "activation_energy", "reference")
    bell = values["velocity"] is not None
    for name, allowed in (
        ("velocity", not file),
        ("creep_velocity", bell),
        ("activation_energy", bell or bool(file)),
    ):
        if values[name] is not None and not allowed:
            kind = "a table" if file else "a constant stress, without velocity and width,"
            raise UserError(f"{where}.{name} = {values[name]:g}: {kind} has none; omit it")
    if not file:
        return Shear(**values)
    rows, description = _read_rows(f"{where}.file", folder / file)
    return Shear(**values, rows=rows, description=description)


def _check_together(where: str, values: Mapping[str, Any], *names: str) -> None:
    """Raise UserError if one of two keys is given without the other."""
    missing = [name for name in names if values[name] is None]
    if len(missing) == 1:
        other = next(name for name in names if name not in missing)
        raise UserError(f"{where}.{missing[0]}: missing; {where}.{other} needs it")


def _read_rows(key: str, path: Path) -> tuple[tuple[tuple[float, float], ...], str]:
    """Return rows (speed in m/s, stress in Pa) of a file, and a description. Raises UserError."""
    table = read_text_table(key, path, path.name)
    columns = select_columns(table, (SPEED_COLUMN, STRESS_COLUMN), None, SHEAR_HEADER_ADVICE)
    speeds, stresses = (column.values for column in columns)
    values = {"a velocity (m/s)": speeds, "a stress (Pa)": stresses}
    rule = "give positive velocities, and stresses that are not negative"
    check_rows(table.prefix, values, (POSITIVE_NUMBER, 0.0), rule)
    rows = zip(speeds.tolist(), stresses.tolist(), strict=True)
    return tuple(rows), describe_columns(table, columns)


SHEAR = {
    "stress": OPTIONAL(
        partial(within, least=0.0, most=MAX_SHEAR_STRESS),
        "The shear stress τ₀ of the real contact: the maximum of a bell over the velocity, or a "
        "constant.",
        "Doubled, the shear part of the friction doubles.",
        "Pa",
        usual="required unless `file` is given",
    ),
    "velocity": OPTIONAL(
        positive,
        "The velocity v₀ at the maximum of the bell τ₀ exp(−(log₁₀(v a'/v₀)/w)²).",
        "Doubled, the bell moves to twice the velocity.",
        "m/s",
        usual="none: a constant stress",
    ),
    "width": OPTIONAL(
        positive,
        "The width w of the bell, at which τ_f has fallen to 1/e; c = 1/w² in the literature.",
        "Doubled, the bell is twice as wide.",
        "decades",
        usual="required with `velocity`",
    ),
    "creep_velocity": OPTIONAL(
        positive,
        "The velocity below which the stress stays constant, so that it does not vanish in a hold.",
        "Doubled, the static stress is that at twice the velocity.",
        "m/s",
        usual="required for a bell with a hold or a drive",
    ),
    "activation_energy": OPTIONAL(
        positive,
        "The activation energy E_a in a' = exp(E_a/R (1/T − 1/T_ref)), which shifts the velocity.",
        "Doubled, the bell shifts by twice as many decades.",
        "J/mol",
        usual="required for a bell if `material.temperature` is given",
    ),
    "reference": OPTIONAL(
        number,
        "The temperature of the bell or the table.",
        "Doubling degrees Celsius has no meaning.",
        "°C",
        usual="required with `activation_energy`",
    ),
    "file": FILE_NAME(
        "A text file beside `study.toml` with columns v (m/s) and τ_f (Pa), or as its header "
        "says, interpolated over the logarithm of v. Below the first row the stress is constant; "
        "a velocity beyond the last row is refused.",
        default="",
    ),
}
