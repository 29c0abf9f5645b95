"""The response to a small oscillation about rest, which follows from the complex modulus.

An element in contact is displaced by z' X, so that the force along the line is
F = 4 L <z'^2> (G* - G) X: what its rubber adds to the relaxed modulus, which by itself gives no
friction, weighted by the squared slope over what is in contact. The mean indentation stays, as
the slope over a contact has no mean. Height and slope of a Gaussian line are independent at a
point, so that <z'^2> is the contact fraction times the squared rms slope: no number is fitted.
(Within a line they are not quite independent: at a quarter in contact this <z'^2> is 4 % too large,
at a half less than 1 %, by 600 lines of this study each.)
"""

import json
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from elastomer_friction.kernels.rheology.spectrum import Spectrum, complex_modulus


class Motion(NamedTuple):
    """An oscillation of the programme of a study."""

    segment: int  # number of it
    amplitude: float  # m
    frequency: float  # Hz
    end: float  # s since the start of the programme


def told(data: xr.Dataset) -> dict[str, Any]:
    """Return the settings with which a result was computed."""
    settings: dict[str, Any] = json.loads(data.attrs["study"])
    return settings


def motions(data: xr.Dataset) -> list[Motion]:
    """Return the oscillations of the programme of a result, which else only holds."""
    found: list[Motion] = []
    time = 0.0
    for number, segment in enumerate(told(data)["scene"]["programme"]):
        if "hold" in segment:
            time += segment["hold"]["duration"]
            continue
        swung = segment["oscillate"]
        time += swung["cycles"] / swung["frequency"]
        found.append(Motion(number, swung["amplitude"], swung["frequency"], time))
    return found


def shift(data: xr.Dataset) -> np.ndarray:
    """Return a_T at the temperatures of a result, shape (temperatures,)."""
    wlf = told(data)["material"]["wlf"]
    above = data.temperature.values - wlf["reference"]
    return 10.0 ** (-wlf["c1"] * above / (wlf["c2"] + above))


def modulus(data: xr.Dataset, name: str, omega: np.ndarray) -> np.ndarray:
    """Return G*/G - 1 of a variant at angular frequencies (rad/s) and the reference temperature."""
    settings = told(data)
    material = settings["material"] | settings["compare"].get(name, {})
    branches = sorted(material.get("branches", []), key=lambda branch: branch[1])
    moduli = tuple(g / material["shear_modulus"] for g, _ in branches)
    times = tuple(time for _, time in branches)
    return complex_modulus(Spectrum(moduli, times, material["relaxation_time"]), omega) - 1.0


def unit(data: xr.Dataset) -> np.ndarray:
    """Return the friction that stands for G* - G = G, shape (temperatures,)."""
    settings = told(data)
    amplitude = motions(data)[-1].amplitude
    stiffness = 4.0 * settings["material"]["shear_modulus"] * settings["surface"]["length"]
    contact = data.trace_contact_fraction.isel(event=0)
    unit = stiffness * amplitude / data.normal_force * data.rms_slope**2 * contact
    return np.asarray(unit.values)
