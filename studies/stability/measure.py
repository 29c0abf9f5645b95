"""Measure residuals and iteration counts over a map of Fbar and x, and in all corners."""

from collections.abc import Callable
from functools import partial
from itertools import product

import numpy as np
import pandas as pd
import xarray as xr

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Key, integer

from .probe import COUNTS, RESIDUALS, Motion, corners, count_corners, probe, random_line, refinement

MAP_HURST, MAP_STEPS, MAP_RATIO = 0.7, 4, 1.2
PROBED = RESIDUALS | COUNTS
SECONDS_PER_STEP = 9e-5  # of a short line, on a typical machine
SECONDS_PER_SAMPLE = 9.5e-8  # added per sample and step
SECONDS_PER_LONG_ELEMENT = 5.8e-6  # of a very long line, for all of its steps
SETTINGS = {  # documented in docs/reference/measures.md
    "map_loads": Key(partial(integer, least=2)),
    "map_speeds": Key(partial(integer, least=2)),
    "map_elements": Key(partial(integer, least=8)),
    "map_lines": Key(partial(integer, least=1)),
    "corner_lines": Key(partial(integer, least=1)),
    "most_elements": Key(partial(integer, least=1)),
    "steps": Key(partial(integer, least=1)),
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return a description of the measurement, and the predicted seconds of one core."""
    points = settings["map_loads"] * settings["map_speeds"] * len(SCHEMES)
    cases = count_corners(settings["corner_lines"], settings["most_elements"])
    lines = [
        f"map         {points} points, {settings['map_lines']} lines each",
        f"corners     {cases} cases of {settings['steps']} steps",
    ]
    long = sum(
        n * 4 * SECONDS_PER_LONG_ELEMENT for n in (10**5, 10**6) if n <= settings["most_elements"]
    )
    corner = _seconds(settings, 250)  # 250 : mean number of samples in the corners
    return lines, points * _map_seconds(settings) + cases * corner + long


def _seconds(settings: dict, samples: int) -> float:
    return (settings["steps"] + 40) * (SECONDS_PER_STEP + SECONDS_PER_SAMPLE * samples)


def _map_seconds(settings: dict) -> float:
    return settings["map_lines"] * _seconds(settings, MAP_STEPS * settings["map_elements"])


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the map, and in group "corners" one row per case."""
    return {"": _map(settings, seed, advance), "corners": _corners(settings, seed, advance)}


def _map(settings: dict, seed: int, advance: Callable[[float], None]) -> xr.Dataset:
    loads = np.geomspace(1e-6, 1e4, settings["map_loads"])
    speeds = np.geomspace(1e-4, 1e6, settings["map_speeds"])
    n = settings["map_elements"]
    both = [  # the same lines with m and 2 m samples per spacing
        [random_line(MAP_HURST, n, m, seed, index) for m in (MAP_STEPS, 2 * MAP_STEPS)]
        for index in range(settings["map_lines"])
    ]
    axes = {"scheme": list(SCHEMES), "mean_load": loads, "speed_ratio": speeds}
    rows = []
    for scheme, load, x in product(SCHEMES, loads.tolist(), speeds.tolist()):
        residuals = []
        for line, fine in both:
            motion = Motion(line, load, x / np.pi, MAP_RATIO, scheme)
            worst = probe(motion, settings["steps"])
            residuals.append(worst | {"refinement": refinement(motion, fine, MAP_HURST)})
        rows.append({kind: max(worst[kind] for worst in residuals) for kind in residuals[0]})
        advance(_map_seconds(settings))
    shape = (len(SCHEMES), loads.size, speeds.size)
    data = {
        kind: (list(axes), np.reshape([row[kind] for row in rows], shape), _attributes(kind))
        for kind in rows[0]
    }
    return xr.Dataset(
        data, axes, {"hurst": MAP_HURST, "elements": n, "steps_per_spacing": MAP_STEPS}
    )


def _corners(settings: dict, seed: int, advance: Callable[[float], None]) -> xr.Dataset:
    rows = []
    arguments = (settings["corner_lines"], settings["most_elements"], settings["steps"])
    for corner in corners(seed, *arguments):
        motion = corner.motion
        rows.append(
            {
                "line": corner.line,
                "elements": corner.elements,
                "steps_per_spacing": motion.line.steps_per_spacing,
                "mean_load": motion.load,
                "speed_ratio": np.pi * motion.speed,
                "ratio": motion.ratio,
                "scheme": motion.scheme,
                **probe(motion, corner.steps),
            }
        )
        samples = motion.line.z.size
        long = samples > 10**4
        advance(samples * SECONDS_PER_LONG_ELEMENT if long else _seconds(settings, 250))
    data = {name: ("case", [row[name] for row in rows], _attributes(name)) for name in rows[0]}
    return xr.Dataset(data)


def _attributes(name: str) -> dict[str, str]:
    """Return the attributes of a variable; residuals are relative."""
    known = PROBED | {
        "refinement": "|mu_1(2 m) - mu_1(m)| / rms slope",
        "mean_load": "Fbar = F_N / (4 G L h)",
        "speed_ratio": "x = v1 tau q_max",
        "ratio": "v2 / v1",
    }
    return {"long_name": known.get(name, name.replace("_", " ")), "units": "1"}


def table(groups: Groups) -> pd.DataFrame:
    """Return the worst value of every kind over the map and the corners, with its case."""
    data = groups[""]
    points = data.to_dataframe().reset_index()
    settings = {"line": f"H = {data.hurst:g}", "elements": data.elements, "ratio": MAP_RATIO}
    points = points.assign(**settings, steps_per_spacing=data.steps_per_spacing)
    cases = pd.concat([points, groups["corners"].to_dataframe()], ignore_index=True)
    where = ["line", "elements", "steps_per_spacing", "mean_load", "speed_ratio", "ratio", "scheme"]
    rows = []
    for kind, meaning in PROBED.items():
        worst = cases.iloc[int(np.nanargmax(cases[kind].to_numpy()))]
        row = {"kind": kind, "meaning": meaning, "cases": len(cases), "worst": worst[kind]}
        rows.append(row | {name: worst[name] for name in where if worst[kind] > 0.0})
    return pd.DataFrame(rows)
