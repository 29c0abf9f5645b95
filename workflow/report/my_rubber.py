"""What a page needs to give the friction of a rubber that was not computed, by scaling alone.

Steady friction over the rms slope depends on H, the number of elements, F = F_N/(E* L h),
x = v tau q_max and the proportions of the branches alone (docs/model.md, "Dimensionless form").
So one result holds every modulus, tau, h and q_max, as far as its loads and velocities go, and
every temperature, which multiplies all times by one factor.
"""

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import xarray as xr

from ..study import (
    COMMON_AXES,
    FOUNDATION,
    INCOMPRESSIBLE,
    MAX_SHIFT_DECADES,
    Wlf,
    changed_material,
    shift_law_of,
)

NEEDED = ("mu_1", "rms_slope", "tau", "q_max", "shear_modulus", "length", "speed_ratio")
USUAL = Wlf(8.86, 101.6, 0.0)  # about T_s, some 50 K above the glass transition
AROUND = range(-40, 101)  # degrees about the temperature of the result
MOST_MOMENTS = 500_000  # of the motions of a rubber, about 16 MB
STEEPEST = 0.3  # largest rms slope that is called small: its square, here a tenth, is neglected
ONE_TIME = "eqs. 12 to 16 are those of one relaxation time"


def scaled_friction(groups: Mapping[str, xr.Dataset]) -> dict[str, Any] | None:
    """Return the rubbers of a result without dimensions, and why others are none.

    groups : the study "" and its comparisons. It is None where no group has steady friction.
    """
    tables = json.loads(groups[""].attrs["study"])
    rubbers, without = [], []
    for name, data in groups.items():
        if "mu_1" not in data:
            continue
        table = changed_material(
            tables.get("material", {}), tables.get("compare", {}).get(name, {})
        )
        body = data.attrs.get("body", groups[""].attrs.get("body"))
        called = name or "the study"
        why = _why_not(data, body) or ""
        rubber = None if why else _rubber(called, data, table)
        if rubber is not None:
            rubbers.append(rubber)
        else:
            why = why or "steady friction is known nowhere at all velocities"
            without.append(f"No rubber is scaled from {called}: {why}.")
    found = {"rubbers": rubbers, "without": without, "steepest": STEEPEST}
    return found if rubbers or without else None


def _why_not(data: xr.Dataset, body: str | None) -> str | None:
    """Return why the friction of a group holds for no other rubber, None where it does."""
    missing = [name for name in NEEDED if name not in data.variables]
    if missing:
        return f"the result has no {missing[0]}"
    if body != FOUNDATION:
        return f"the kinetic law and its scaling are those of the foundation, this is a {body}"
    others = set(map(str, data.mu_1.dims)) - {*COMMON_AXES, "temperature"}
    if others:
        return f"its friction depends on {', '.join(sorted(others))} as well"
    if data.sizes["velocity"] < 2:
        return "it has one velocity, and µ(v) needs two or more"
    if not np.isfinite(data.hurst.values).all():
        return "the Hurst exponent of its lines is not known"
    return None


def _rubber(name: str, data: xr.Dataset, material: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return own values, curves and temperatures of one group; None where friction is not known.

    ``curves`` has one entry for each load and H, and ``family`` tells those of one L q_max and one
    set of x. Own values are of the steepest lines that the model allows, else of the gentlest.
    """
    data = data.isel(velocity_step=0).sortby("velocity")
    contact = 2.0 / (1.0 - material.get("poisson", INCOMPRESSIBLE))  # E*/G
    several = bool(material.get("branches") or "branches_file" in material)
    known = [(at, c) for at in _places(data) if (c := _curve(at, contact, several)) is not None]
    if not known:
        return None
    first, chosen = max(known, key=lambda each: _allowed(each[0]))
    curves = [curve for _, curve in known]
    kept = [pair for each in curves for pair in each["motions"] or [] if pair]
    if sum(len(time) for time, _ in kept) > MOST_MOMENTS:
        curves = [each | {"motions": None} for each in curves]
    own = {key: float(first[key]) for key in ("shear_modulus", "tau", "roughness", "q_max")}
    own |= {"pressing": float(first.normal_force) / float(first.length)}
    branches = material.get("branches", [])
    glassy = branches and not material.get("relaxation_time")
    return {
        "name": name,
        "own": own | {key: chosen[key] for key in ("hurst", "family")},
        "contact": contact,
        "branches": [[g / own["shear_modulus"], t / _tau(material)] for g, t in branches],
        "glassy": 1.0 + sum(g for g, _ in branches) / own["shear_modulus"] if glassy else None,
        "without_steps": ONE_TIME if several else None,
        "temperature": _temperatures(data, first, material),
        "curves": curves,
    }


def _allowed(at: xr.Dataset) -> float:
    """Return a rank by the rms slope: the largest that is small, else the smallest, is best."""
    slope = float(np.ravel(at.rms_slope)[0])
    return slope if slope <= STEEPEST else -slope


def _tau(material: Mapping[str, Any]) -> float:
    """Return tau (s) at the reference of the shifts."""
    branches = sum(g * t for g, t in material["branches"]) / material["shear_modulus"]
    return float(material.get("relaxation_time", 0.0) + branches)


def _temperatures(
    data: xr.Dataset, first: xr.Dataset, material: Mapping[str, Any]
) -> dict[str, Any]:
    """Return temperatures, by what tau is then multiplied, and which is that of the result.

    They are whole degrees about it, by the shift of the material, and by the usual constants where
    it has none. Of shifts in a file a result holds those at its own temperatures alone.
    """
    law = shift_law_of(material)
    if "temperature" in data.coords and law is None:
        factors = data.tau.values / float(first.tau)
        words = "temperature (one that was computed)"
        return _stops(words, "°C", data.temperature.values, factors, float(first.temperature))
    words, unit, own = "temperature above Ts", "K", 0.0
    if law is None:
        law = USUAL
    else:
        words, unit, own = "temperature", "°C", float(first.temperature)
    known = [own + step for step in AROUND if not law.outside(own + step)]
    decades = np.array([law.decades(each) for each in known]) - law.decades(own)
    kept = np.abs(decades) <= MAX_SHIFT_DECADES
    return _stops(words, unit, np.array(known)[kept], 10.0 ** decades[kept], own)


def _stops(
    words: str, unit: str, degrees: np.ndarray, factors: np.ndarray, own: float
) -> dict[str, Any]:
    """Return the temperatures of a slider; ``own`` is that of the result, with the factor 1."""
    named = {"words": words, "unit": unit, "own": int(np.argmin(np.abs(degrees - own)))}
    return named | {"degrees": degrees.tolist(), "factors": factors.tolist()}


def _places(data: xr.Dataset) -> Iterator[xr.Dataset]:
    """Yield the dataset at each place of the grid, all velocities."""
    axes = [axis for axis in data.mu_1.dims if axis != "velocity"]
    for index in np.ndindex(*(data.sizes[axis] for axis in axes)):
        yield data.isel(dict(zip(axes, index, strict=True)))


def _curve(at: xr.Dataset, contact: float, several: bool) -> dict[str, Any] | None:
    """Return steady friction over x, both without dimensions; None where some of it is unknown.

    contact : E*/G. several : relaxation times, of which no law gives friction over time, so that
    computed motions are returned too.
    """
    slope = float(np.ravel(at.rms_slope)[0])
    friction = at.mu_1.values / slope
    if not (np.isfinite(friction).all() and (friction > 0.0).all()):
        return None
    modulus, roughness, q_max = (
        float(at[name]) for name in ("shear_modulus", "roughness", "q_max")
    )
    size = float(at.length) * q_max
    x = at.velocity.values * float(at.tau) * q_max
    elements = round(float(at.length / at.spacing))
    return {
        "family": f"{elements} {size:.6g} {x[0]:.6g} {x[-1]:.6g}",
        "elements": elements,
        "hurst": float(at.hurst),
        "load": float(at.normal_force) / (contact * modulus * float(at.length) * roughness),
        "slope": slope / (roughness * q_max),
        "size": size,
        "x": x.tolist(),
        "friction": friction.tolist(),
        "error": _share(at, "mu_1_error", at.mu_1.values),
        "bias": _share(at, "mu_1_bias", 1.0),
        "motions": _motions(at, slope) if several else None,
    }


def _motions(at: xr.Dataset, slope: float) -> list[list[list[float]] | None] | None:
    """Return computed times over tau and friction over the slope, of each velocity, or None.

    They are those after the step, else those of the programme.
    """
    for time, mu, unit in (("time", "mu", 1.0), ("trace_time", "trace_mu", float(at.tau))):
        if mu not in at or at[mu].ndim != 2 or set(at[mu].dims) != set(at[time].dims):
            continue
        found: list[list[list[float]] | None] = []
        for k in range(at.sizes["velocity"]):
            t, y = (at[name].isel(velocity=k).values for name in (time, mu))
            known = np.isfinite(t) & np.isfinite(y)
            pair = [(t[known] / unit).tolist(), (y[known] / slope).tolist()]
            found.append(pair if known.sum() > 1 else None)
        return found
    return None


def _share(at: xr.Dataset, name: str, of: Any) -> list[float | None]:
    """Return an error as a share of friction at each velocity, None where it is not known."""
    if name not in at:
        return [None] * at.sizes["velocity"]
    return [float(share) if np.isfinite(share) else None for share in at[name].values / of]
