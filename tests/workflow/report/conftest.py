"""One report for all tests that look at one: figures take long to draw."""

import pytest
from matplotlib import pyplot as plt

from tests.support.synthetic import add, result, write_figure_8
from workflow.report.report import write_report
from workflow.result.netcdf import write_datasets


@pytest.fixture(autouse=True)
def _closed_figures():
    yield
    plt.close("all")


@pytest.fixture(scope="package")
def folder(tmp_path_factory):
    """Return a folder with a narrow figure, 8, and one wider than a phone, 5, and their report."""
    folder = tmp_path_factory.mktemp("results")
    write_figure_8(folder)
    wide = result("fig5", hurst=[0.7])
    wide = add(wide, mu_1=wide.velocity, mu_2=1.2 * wide.velocity, jump=0.2 * wide.velocity)
    write_datasets(folder / "fig5.nc", {"": wide})
    write_report(folder, [])
    plt.close("all")
    return folder
