"""One report for all tests of the page."""

from types import SimpleNamespace

import pytest
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import figure
from elastomer_friction.workflow.report.page import write_report
from elastomer_friction.workflow.report.panels import error_bars
from elastomer_friction.workflow.result.netcdf import write_datasets
from tests.support.synthetic import add, result, write_figure_8

CAPTION = "The rms slope is shown. Its errors are, too."


def draw(groups):
    """Return a figure that is quick to draw: 3 inches wide for each H, a point per velocity."""
    data = groups[""]
    figure = Figure(figsize=(3.0 * data.hurst.size, 2.0))
    points = data.isel(hurst=0, normal_force=0, spacing=0, roughness=0, velocity_step=0)
    ax = figure.subplots()
    error_bars(ax, points, "rms_slope", "velocity", fmt="o")
    ax.set_xscale("log")
    return figure


@pytest.fixture(scope="package")
def report():
    """Return a function that writes the report of a folder, with quick figures."""

    def write(folder):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(
                figure, "_script", lambda study, _: SimpleNamespace(draw=draw, CAPTION=CAPTION)
            )
            return write_report(folder, [])

    return write


@pytest.fixture(scope="package")
def folder(tmp_path_factory, report):
    """Return a folder with a narrow figure, 5, and one wider than a phone, 8, and their report."""
    folder = tmp_path_factory.mktemp("results")
    write_figure_8(folder)
    narrow = result("fig5", hurst=[0.7])
    velocity = narrow.velocity
    narrow = add(narrow, mu_1=velocity, mu_2=1.2 * velocity, jump=0.2 * velocity)
    write_datasets(folder / "fig5.nc", {"": narrow})
    report(folder)
    return folder
