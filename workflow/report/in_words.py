"""Wording of variables, units, numbers and points of a result."""

import json
import re
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.ticker import EngFormatter

from ..study import ALL_AXES

SYMBOLS = {
    "hurst": "H",
    "normal_force": "F_N",
    "normal_pressure": "p",
    "spacing": "Δx",
    "roughness": "h",
    "velocity": "v₁",
    "velocity_step": "Δv/v₁",
    "prescribed_indentation": "d",
    "temperature": "T",
    "hold": "t_h",
    "stiffness": "k",
    "speed_ratio": "x",
    "mu_1": "µ₁",
    "mu": "µ",
    "jump": "Δµ₀",
    "jump_over_step": "Δµ₀/(Δv/v₁)",
    "relaxation_rate": "b",
    "alpha": "α",
}
PLAIN = 0.1, 1e3  # range in which a number is written without an SI prefix
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit_in_words(variable: xr.DataArray) -> str:
    """Return the unit of a variable in common notation, such as m/s; "" if dimensionless."""
    unit = str(variable.attrs.get("units", "1"))
    if unit in ("1", "degree_Celsius"):
        return "" if unit == "1" else "°C"
    above, below = re.subn(r" ?([A-Za-z]+)-1\b", "", unit)[0], re.findall(r"([A-Za-z]+)-1\b", unit)
    return "/".join([above or "1", *below])


def with_unit(value: float, unit: str = "", digits: int = 3) -> str:
    """Return a number as readable text, such as 10 µm, 1 MPa, 0.05 m/s or 2·10⁻⁵."""
    rounded = float(f"{value:.{digits}g}")
    plain = rounded == 0.0 or PLAIN[0] <= abs(rounded) < PLAIN[1] or not np.isfinite(rounded)
    if unit[:1].isalpha() and not plain:
        return EngFormatter(unit)(rounded)
    mantissa, _, power = f"{rounded:g}".partition("e")
    if power:
        raised = f"10{str(int(power)).translate(SUPERSCRIPTS)}"
        mantissa = f"{mantissa}·{raised}".removeprefix("1·")
    return f"{mantissa.replace('-', '−')} {unit}".rstrip()


def value_label(name: str, value: float, unit: str, digits: int = 3) -> str:
    """Return the value of a variable as text, such as "H = 0.7" or "Δx = 2 µm"."""
    return f"{SYMBOLS.get(name, name)} = {with_unit(value, unit, digits)}"


def plus_minus(error: float, text: str) -> str:
    """Return a standard error as a suffix to its estimate; text : the error in words if known."""
    return f" ± {text}" if np.isfinite(error) else " (error unknown)"


def mathematical(text: str) -> str:
    """Return a text with indexed symbols, such as F_N, typeset for matplotlib."""
    return re.sub(r"\b(\w)_(\w)\b", r"$\1_\2$", text)


def without_tau(data: xr.Dataset) -> xr.Dataset:
    """Return a result with times in s alone if its material has several relaxation times."""
    if not has_branches(json.loads(data.attrs["study"]).get("material", {})):
        return data
    names = [name for name in ("relaxation_rate", "relaxation_rate_error") if name in data]
    label = {"long_name": "relaxation rate of eq. 6", "units": "s-1"}
    rates = {name: (data[name] / data.tau).assign_attrs(label) for name in names}
    return data.assign(rates).drop_vars("time", errors="ignore")


def has_branches(material: Mapping[str, Any]) -> bool:
    """Return whether a table [material] has several relaxation times."""
    return bool(material.get("branches") or "branches_file" in material)


def axes_in(data: xr.Dataset) -> list[str]:
    """Return the axes of the grid that are dimensions of a result, in the order of ALL_AXES."""
    return [axis for axis in ALL_AXES if axis in data.dims]
