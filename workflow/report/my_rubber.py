"""What a page needs to give the kinetic law of a rubber that was not computed, by scaling alone.

Steady friction over the rms slope depends on H, the number of elements, F = F_N/(4 G L h) and
x = v tau q_max alone (docs/model.md, "Dimensionless form"). So one result holds every G, tau, h
and q_max, as far as its loads, Hurst exponents and velocities go.
"""

import json
from typing import Any

import numpy as np
import xarray as xr

from ..study import AXES, FOUNDATION

KELVIN = {"shear_modulus", "relaxation_time"}  # the keys of [material] of the paper's element
NEEDED = ("mu_1", "rms_slope", "tau", "q_max", "shear_modulus", "length", "speed_ratio")


def scaled_friction(data: xr.Dataset) -> dict[str, Any] | None:
    """Return the friction of a result without dimensions, and its own rubber, or None.

    It is None beside Kelvin elements on a foundation, with two velocities or more. ``curves``
    has one entry for each load and H, and ``family`` tells those of one L q_max and one set of x.
    """
    material = json.loads(data.attrs["study"]).get("material", {})  # that of a measured study: none
    there = all(name in data.variables for name in NEEDED) and set(data.mu_1.dims) == set(AXES)
    if not there or set(material) != KELVIN or data.attrs.get("body") != FOUNDATION:
        return None
    data = data.isel(velocity_step=0).sortby("velocity")
    curves = [curve for place in _places(data) if (curve := _curve(place)) is not None]
    if data.sizes["velocity"] < 2 or not curves:
        return None
    first = next(_places(data))
    own = {name: float(first[name]) for name in ("shear_modulus", "tau", "roughness", "q_max")}
    pressing = float(first.normal_force) / float(first.length)
    return {"own": own | {"pressing": pressing, "hurst": float(first.hurst)}, "curves": curves}


def _places(data: xr.Dataset) -> Any:
    """Yield the dataset at each place of the grid, all velocities."""
    axes = [axis for axis in AXES if axis not in ("velocity", "velocity_step")]
    for index in np.ndindex(*(data.sizes[axis] for axis in axes)):
        yield data.isel(dict(zip(axes, index, strict=True)))


def _curve(at: xr.Dataset) -> dict[str, Any] | None:
    """Return steady friction over x, both without dimensions; None where some of it is unknown."""
    slope = float(np.ravel(at.rms_slope)[0])
    friction = at.mu_1.values / slope
    if not (np.isfinite(friction).all() and (friction > 0.0).all()):
        return None
    modulus, roughness, q_max = (
        float(at[name]) for name in ("shear_modulus", "roughness", "q_max")
    )
    size = float(at.length) * q_max
    x = at.velocity.values * float(at.tau) * q_max
    return {
        "family": f"{size / np.pi:.0f} elements, x from {x[0]:.3g} to {x[-1]:.3g}",
        "hurst": float(at.hurst),
        "load": float(at.normal_force) / (4.0 * modulus * float(at.length) * roughness),
        "slope": slope / (roughness * q_max),
        "size": size,
        "x": x.tolist(),
        "friction": friction.tolist(),
        "error": _share(at, "mu_1_error", at.mu_1.values),
        "bias": _share(at, "mu_1_bias", 1.0),
    }


def _share(at: xr.Dataset, name: str, of: Any) -> list[float | None]:
    """Return an error as a share of friction at each velocity, None where it is not known."""
    if name not in at:
        return [None] * at.sizes["velocity"]
    return [float(share) if np.isfinite(share) else None for share in at[name].values / of]
