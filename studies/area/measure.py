"""Real contact area of an elastic half-space over the pressure and the number of samples.

The spectrum is that of published values, C_2D ~ q^(-2 (H + 1)) from q_r = 1e4 to q_s = 1e6 1/m
with H = 0.8 and an rms height of 6 um for the integral over this ring. The side of the cells is
2 pi/q_r, so that sums over their few longest modes exceed that integral: the rms height is 7.9 um,
and the slope, on which the area depends, 0.281 instead of 0.277. All scales have this spectrum;
they differ in the number of maps and of samples.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import pandas as pd
import xarray as xr

from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.patches import real_contact
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.half_space.waves import half_space_stiffness
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Key, integer

HURST, RMS_HEIGHT, LONGEST_WAVE = 0.8, 6e-6, 2.0 * np.pi / 1e4  # m
LAST_MODE = 100  # q_s/q_r
ELEMENTS = 2 * LAST_MODE  # of a side: two in the shortest wave
# Pressure over E* -> A/A_0, by Green's function molecular dynamics of another group.
GFMD_AREAS = {
    0.001: 0.00827,
    0.005: 0.0399,
    0.01: 0.0779,
    0.025: 0.1853,
    0.04: 0.2846,
    0.065: 0.4326,
    0.113: 0.6571,
    0.191: 0.8739,
    0.24: 0.9406,
    0.37: 0.9951,
}
CONTACT_TOLERANCE = 1e-4
SECONDS_PER_SAMPLE = 9e-7  # per sample of a map and pressure
SETTINGS = {  # documented in docs/reference/measures.md
    "maps": Key(partial(integer, least=2)),
    "finest": Key(partial(integer, least=4)),
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return a description of the measurement, and the predicted seconds of one core."""
    ladder = samples_per_wave(settings["finest"])
    sides = ", ".join(str(LAST_MODE * samples) for samples in ladder)
    lines = [f"maps        {settings['maps']} with {sides} samples a side"]
    return lines, settings["maps"] * sum(_seconds(samples) for samples in ladder)


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the corrected and the counted area of every map beside the published ones."""
    pressures, maps = list(GFMD_AREAS), range(settings["maps"])
    ladder = samples_per_wave(settings["finest"])
    amplitudes = ring_amplitudes(HURST, ELEMENTS, 1.0, LAST_MODE, "integral")
    areas = np.empty((len(pressures), len(ladder), len(maps), 2))
    for j, samples in enumerate(ladder):
        side = LAST_MODE * samples
        operator = Operator.of(half_space_stiffness((side, side), 1), side)
        for k in maps:
            generator = np.random.default_rng([seed, k])
            surface = Surface.drawn(generator, amplitudes, ELEMENTS, side // ELEMENTS)
            heights = surface.z * RMS_HEIGHT * side / LONGEST_WAVE  # in samples
            for i, pressure in enumerate(pressures):
                p = press(heights, pressure, operator, None, CONTACT_TOLERANCE).p
                areas[i, j, k] = real_contact(p, 0.0), np.mean(p > 0.0)
            advance(_seconds(samples))
    share, of_map = {"units": "1"}, ("pressure", "samples", "map")
    data = {
        "area": (of_map, areas[..., 0], share | {"long_name": "corrected area over A0"}),
        "count": (of_map, areas[..., 1], share | {"long_name": "samples in contact over all"}),
        "published": ("pressure", list(GFMD_AREAS.values()), share | {"long_name": "A/A0, GFMD"}),
    }
    places = {
        "pressure": ("pressure", pressures, share | {"long_name": "nominal pressure over E*"}),
        "samples": ("samples", ladder, share | {"long_name": "samples in the shortest wave"}),
    }
    return {"": xr.Dataset(data, places)}


def samples_per_wave(finest: int) -> list[int]:
    """Return the numbers of samples in the shortest wave: 2, 4, 8, ... up to ``finest``."""
    return [2**power for power in range(1, finest.bit_length())]


def mean_and_error(values: xr.DataArray) -> tuple[xr.DataArray, xr.DataArray]:
    """Return the mean over the maps, and its standard error."""
    return values.mean("map"), values.std("map", ddof=1) / np.sqrt(values.sizes["map"])


def table(groups: Groups) -> pd.DataFrame:
    """Return published and computed areas, those on the finest maps, and their ratio."""
    data = groups[""].isel(samples=-1)
    area, error = mean_and_error(data.area)
    columns = {
        "pressure": data.pressure,
        "published": data.published,
        "area": area,
        "area_error": error,
        "ratio": area / data.published,
    }
    return pd.DataFrame({name: values.values for name, values in columns.items()})


def _seconds(samples: int) -> float:
    """Return the predicted seconds of one map at all pressures."""
    return SECONDS_PER_SAMPLE * len(GFMD_AREAS) * (LAST_MODE * samples) ** 2
