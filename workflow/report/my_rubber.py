"""Data with which the explorer scales a result to another rubber.

Steady friction over the rms slope depends only on H, the number of elements, F = F_N/(E* L h),
x = v tau q_max and the proportions of the branches (docs/model.md, "Dimensionless form"). One
result therefore covers every modulus, tau, h and q_max within its range of F and x. It also covers
every temperature, since a temperature multiplies all relaxation times by one factor.
"""

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import xarray as xr

from ...kernels import Wlf
from ..study import (
    COMMON_AXES,
    FOUNDATION,
    INCOMPRESSIBLE,
    MAX_SHIFT_DECADES,
    changed_material,
    shift_law_of,
    shift_refusal,
)
from .in_words import has_branches

SCALING_VARIABLES = ("mu_1", "rms_slope", "tau", "q_max", "shear_modulus", "length", "speed_ratio")
UNIVERSAL_WLF = Wlf(8.86, 101.6, 0.0)  # reference T_s, some 50 K above the glass transition
SLIDER_DEGREES = range(-40, 101)  # K, relative to the temperature of the result
MAX_MOTION_SAMPLES = 500_000  # per rubber, about 16 MB
MAX_SMALL_SLOPE = 0.3  # largest small rms slope; the model neglects the square of slopes
ONE_TIME_NOTE = "eqs. 12 to 16 are those of one relaxation time"
NO_HURST_NOTE = "eqs. 12 to 16 need a Hurst exponent, which measured lines do not have"


def scaled_friction(groups: Mapping[str, xr.Dataset]) -> dict[str, Any] | None:
    """Return the dimensionless rubbers of a result, and the reasons for groups without one.

    groups : the study, named "", and its comparisons. Returns None if no group has steady friction.
    """
    tables = json.loads(groups[""].attrs["study"])
    material, compared = tables.get("material", {}), tables.get("compare", {})
    rubbers, without = [], []
    for name, data in groups.items():
        if "mu_1" not in data:
            continue
        label = name or "the study"
        obstacle = _obstacle(data, data.attrs.get("body", groups[""].attrs.get("body")))
        if not obstacle:
            rubber = _rubber(label, data, changed_material(material, compared.get(name, {})))
            if rubber is not None:
                rubbers.append(rubber)
                continue
            obstacle = "steady friction is known nowhere at all velocities"
        without.append(f"No rubber is scaled from {label}: {obstacle}.")
    content = {"rubbers": rubbers, "without": without, "steepest": MAX_SMALL_SLOPE}
    return content if rubbers or without else None


def _obstacle(data: xr.Dataset, body: str | None) -> str:
    """Return the reason that prevents scaling a group to other rubbers, or ""."""
    missing = [name for name in SCALING_VARIABLES if name not in data.variables]
    if missing:
        return f"the result has no {missing[0]}"
    if body != FOUNDATION:
        return f"the kinetic law and its scaling are those of the foundation, this is a {body}"
    others = set(map(str, data.mu_1.dims)) - {*COMMON_AXES, "temperature"}
    if others:
        return f"its friction depends on {', '.join(sorted(others))} as well"
    if data.sizes["velocity"] < 2:
        return "it has one velocity, and µ(v) needs two or more"
    return ""


def _rubber(name: str, data: xr.Dataset, material: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the values, curves and temperatures of one group, or None if no curve is known.

    ``curves`` has an entry for each known point on the axes other than velocity. Entries with the
    same number of elements, L q_max and range of x share a ``family``. ``own`` holds the values of
    the steepest lines with a small slope, or of the flattest lines if no slope is small.
    """
    data = data.isel(velocity_step=0).sortby("velocity")
    contact = 2.0 / (1.0 - material.get("poisson", INCOMPRESSIBLE))  # E*/G
    several = has_branches(material)
    without_steps = ONE_TIME_NOTE if several else None
    if not np.isfinite(data.hurst.values).all():
        without_steps = without_steps or NO_HURST_NOTE
    computed = bool(without_steps)
    known = [(at, c) for at in _points(data) if (c := _curve(at, contact, computed)) is not None]
    if not known:
        return None
    first, chosen = max(known, key=lambda pair: _slope_rank(pair[0]))
    curves = [curve for _, curve in known]
    motions = [motion for curve in curves for motion in curve["motions"] or [] if motion]
    if sum(len(time) for time, _ in motions) > MAX_MOTION_SAMPLES:
        curves = [curve | {"motions": None} for curve in curves]
    values = {key: float(first[key]) for key in ("shear_modulus", "tau", "roughness", "q_max")}
    values |= {"pressing": float(first.normal_force) / float(first.length)}
    branches = material.get("branches", [])
    glassy = branches and not material.get("relaxation_time")
    tau = material.get("relaxation_time", 0.0)  # at the reference temperature of the shifts
    tau += sum(g * t for g, t in branches) / values["shear_modulus"]
    return {
        "name": name,
        "own": values | {key: chosen[key] for key in ("hurst", "family")},
        "contact": contact,
        "branches": [[g / values["shear_modulus"], t / tau] for g, t in branches],
        "glassy": 1.0 + sum(g for g, _ in branches) / values["shear_modulus"] if glassy else None,
        "several": several,
        "without_steps": without_steps,
        "temperature": _temperatures(data, first, material),
        "curves": curves,
    }


def _slope_rank(at: xr.Dataset) -> float:
    """Return a rank, highest for the largest small slope, else for the smallest slope."""
    slope = float(np.ravel(at.rms_slope)[0])
    return slope if slope <= MAX_SMALL_SLOPE else -slope


def _temperatures(
    data: xr.Dataset, first: xr.Dataset, material: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the stops of the temperature slider, with their shift factors of tau.

    The stops are whole degrees about the temperature of the result, shifted by the material's law
    or else by the universal WLF constants. With a file of shifts, they are those of the result.
    """
    law, own = shift_law_of(material), 0.0
    if law is None and "temperature" in data.coords:
        words, unit, own = "temperature (one that was computed)", "°C", float(first.temperature)
        degrees, factors = data.temperature.values, data.tau.values / float(first.tau)
    else:
        words, unit = "temperature above Ts", "K"
        if law is not None:
            words, unit, own = "temperature", "°C", float(first.temperature)
        law = law or UNIVERSAL_WLF
        degrees = np.array([d for k in SLIDER_DEGREES if not shift_refusal(law, d := own + k)])
        decades = np.array([law.decades(d) for d in degrees]) - law.decades(own)
        allowed = np.abs(decades) <= MAX_SHIFT_DECADES
        degrees, factors = degrees[allowed], 10.0 ** decades[allowed]
    return {
        "words": words,
        "unit": unit,
        "own": int(np.argmin(np.abs(degrees - own))),  # of the result, whose factor is 1
        "degrees": degrees.tolist(),
        "factors": factors.tolist(),
    }


def _points(data: xr.Dataset) -> Iterator[xr.Dataset]:
    """Yield the dataset at all velocities for each point on the other axes."""
    axes = [axis for axis in data.mu_1.dims if axis != "velocity"]
    for index in np.ndindex(*(data.sizes[axis] for axis in axes)):
        yield data.isel(dict(zip(axes, index, strict=True)))


def _curve(at: xr.Dataset, contact: float, computed: bool) -> dict[str, Any] | None:
    """Return dimensionless steady friction over x, or None if a value is not finite and positive.

    contact : E*/G. computed : whether to return the computed motions too, because the kinetic law
    does not cover them.
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
        "hurst": float(at.hurst) if np.isfinite(at.hurst) else None,
        "load": float(at.normal_force) / (contact * modulus * float(at.length) * roughness),
        "slope": slope / (roughness * q_max),
        "size": size,
        "x": x.tolist(),
        "friction": friction.tolist(),
        "error": _relative_error(at, "mu_1_error", at.mu_1.values),
        "bias": _relative_error(at, "mu_1_bias", 1.0),
        "motions": _motions(at, slope) if computed else None,
    }


def _motions(at: xr.Dataset, slope: float) -> list[list[list[float]] | None] | None:
    """Return the computed (time/tau, friction/slope) for each velocity, or None if unknown.

    The motion is the velocity step if its friction is in the result, otherwise the programme.
    """
    for time, mu, unit in (("time", "mu", 1.0), ("trace_time", "trace_mu", float(at.tau))):
        if mu not in at or at[mu].ndim != 2 or set(at[mu].dims) != set(at[time].dims):
            continue
        motions: list[list[list[float]] | None] = []
        for k in range(at.sizes["velocity"]):
            t, y = (at[name].isel(velocity=k).values for name in (time, mu))
            known = np.isfinite(t) & np.isfinite(y)
            pair = [(t[known] / unit).tolist(), (y[known] / slope).tolist()]
            motions.append(pair if known.sum() > 1 else None)
        return motions
    return None


def _relative_error(at: xr.Dataset, name: str, friction: Any) -> list[float | None]:
    """Return an error over ``friction`` at each velocity, with None for unknown errors."""
    if name not in at:
        return [None] * at.sizes["velocity"]
    return [float(share) if np.isfinite(share) else None for share in at[name].values / friction]
