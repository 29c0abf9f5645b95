"""A measured study, small enough to run whole: powers of a number."""

from pathlib import Path

STUDY = """
[study]
title = "Powers of two"
seed = 5
[measure]
powers = 3
base = 2.0
[scales.smoke.measure]
powers = 1
"""
MEASURE = """
from functools import partial
import pandas as pd
import xarray as xr
from elastomer_friction.workflow.study import Key, integer, positive
from .helper import power

SETTINGS = {"powers": Key(partial(integer, least=1)), "base": Key(positive)}

def outline(settings):
    return [f"powers      {settings['powers']}"], 0.5 * settings["powers"]

def measure(settings, seed, advance):
    found = []
    for exponent in range(settings["powers"]):
        found.append(power(settings["base"], exponent))
        advance(0.5)
    return {"": xr.Dataset({"found": ("n", found)}), "seed": xr.Dataset({"seed": seed})}

def summary(groups):
    return [f"largest {float(groups[''].found.max()):g}"]

def table(groups):
    return pd.DataFrame({"found": groups[""].found.values})
"""
FIGURE = """
from matplotlib import pyplot as plt
from .helper import power

def draw(groups):
    figure, ax = plt.subplots()
    ax.plot(groups[""].found)
    return figure
"""


def write_powers(root: Path) -> Path:
    """Write the study under studies/ of a folder; return its own folder."""
    folder = root / "studies" / "powers"
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(STUDY)
    (folder / "measure.py").write_text(MEASURE)
    (folder / "figure.py").write_text(FIGURE)
    (folder / "helper.py").write_text("def power(base, n):\n    return base**n\n")
    return folder
