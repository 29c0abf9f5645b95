"""The studies of this repository, run at smoke scale and drawn."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes

from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.report.page import section
from elastomer_friction.workflow.report.panels import STYLE, plain_ticks
from elastomer_friction.workflow.run import workers
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.study.read import known_studies, read_study
from elastomer_friction.workflow.study.scripts import load_script
from elastomer_friction.workflow.study.study import AnyStudy
from tests.support import conventions

Groups = dict[str, xr.Dataset]


def run(
    folder: Path, name: str, *settings: str, variants: Sequence[str] = (), drawn: bool = True
) -> Groups:
    """Run a study at smoke scale with --set ``settings``; return the groups of its result.

    It is computed in this process, whatever its predicted time. variants : labels of those to
    compute; by default all. drawn : whether the figure is tested as well.
    """
    study = read_study(name, "smoke", list(settings))
    chosen = {label: study.variants[label] for label in variants or study.variants}
    path = folder / f"{name}.nc"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(workers, "SECONDS_HERE", math.inf)
        run_plan(make_plan(replace(study, variants=chosen)), path, RunOptions())
    groups = load(path)
    check_section(study, groups, folder)
    if drawn:
        check_drawing(name, groups)
    return groups


def load(path: Path) -> Groups:
    """Return the groups of a result, which must conform to the CF conventions."""
    assert not conventions.INSTALLED or conventions.complaints(path) == []
    with xr.open_datatree(path):  # fails if groups differ in a shared dimension
        pass
    groups = {}
    for group, data in xr.open_groups(path).items():
        groups[group.strip("/")] = data.load()
        data.close()
    return groups


def check_section(study: AnyStudy, groups: Groups, folder: Path) -> None:
    """Check the section of a result in the report, without its figure."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("elastomer_friction.workflow.report.page.draw_groups", lambda *_: [])
        shown = section(study, groups, folder)
    assert shown["troubles"] == []
    units = {meaning: unit for meaning, _, unit in shown["parameters"]}
    assert units["relaxed shear modulus G"] == "Pa"
    assert len(units) == len(shown["parameters"]) >= len(groups[""].realizations.dims)
    assert not any("nan" in values for _, values, _ in shown["parameters"])


def check_drawing(name: str, groups: Groups) -> None:
    """Draw the figure of a study; check that every panel has data and that no labels overlap."""
    script = load_script(known_studies()[name].parent / "figure.py")
    try:
        with mpl.rc_context(STYLE):
            drawn = script.draw(groups)
            for figure in drawn.values() if isinstance(drawn, dict) else [drawn]:
                plain_ticks(figure)
                figure.canvas.draw()
                assert figure.axes
                assert all(ax.has_data() or not ax.axison for ax in figure.axes)
                assert not [ax.get_title() for ax in figure.axes if _labels_overlap(ax)]
    finally:
        plt.close("all")


def _labels_overlap(ax: Axes) -> bool:
    """Return whether two tick labels of the x axis overlap."""
    low, high = sorted(ax.get_xlim())
    labels = ax.get_xticklabels() + ax.get_xticklabels(minor=True)
    shown = [
        label for label in labels if label.get_text() and low <= label.get_position()[0] <= high
    ]
    boxes = sorted((label.get_window_extent() for label in shown), key=lambda box: box.x0)
    return any(one.x1 > other.x0 for one, other in pairwise(boxes)) if ax.axison else False


def rates(data: xr.Dataset, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """Return (x, b) of the fitted points with low <= x <= high."""
    x = data.speed_ratio.values
    chosen = (data.fit_status.values == FITTED) & (x >= low) & (x <= high)
    return x[chosen], data.relaxation_rate.values[chosen]
