"""The notebook studies/explore.ipynb runs from top to bottom on a small result of figure 7."""

import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOK = ROOT / "studies" / "explore.ipynb"
SETTINGS = (
    "study.realizations=20",
    "grid.hurst=[0.3, 0.7]",
    "grid.normal_force=0.1",
    "grid.spacing=1e-5",
    "grid.velocity={geomspace=[1e-3, 1e-1, 4]}",
)
# In a process of its own: the kernel and its event loop stay out of the tests' process.
EXECUTE = """
import sys, nbclient, nbformat
notebook = nbformat.read(sys.argv[1], as_version=4)
nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
nbformat.write(notebook, "executed.ipynb")
"""


def execute(folder):
    """Run the notebook in ``folder``."""
    command = [sys.executable, "-c", EXECUTE, str(NOTEBOOK)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=200)


@pytest.fixture(scope="module")
def outputs(tmp_path_factory):
    """Return the outputs of the notebook beside a small result, one list per code cell."""
    folder = tmp_path_factory.mktemp("explore")
    settings = [word for setting in SETTINGS for word in ("--set", setting)]
    command = [sys.executable, "-m", "workflow", "run", "fig7", *settings]
    command += ["--workers", "1", "--out", str(folder / "results")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=200)
    assert done.returncode == 0, done.stderr
    done = execute(folder)
    assert done.returncode == 0, done.stderr
    notebook = nbformat.read(folder / "executed.ipynb", as_version=4)
    return [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]


def texts(outputs):
    """Return all printed text."""
    return "".join(part.text for cell in outputs for part in cell if "text" in part)


def test_every_cell_runs_without_warnings(outputs):
    assert not [part for cell in outputs for part in cell if part.get("name") == "stderr"]


def test_units_and_origin_are_shown(outputs):
    assert "indentation      [m] steady indentation d at v1" in texts(outputs)
    assert "seed: 2014" in texts(outputs)


def test_the_fit_agrees_with_the_stored_rate(outputs):
    (line,) = [line for line in texts(outputs).splitlines() if line.startswith("b = ")]
    here, stored = float(line.split()[2]), float(line.split()[5])
    assert here == pytest.approx(stored, rel=1e-3)


def test_both_plots_are_drawn(outputs):
    images = [part for cell in outputs for part in cell if "image/png" in part.get("data", {})]
    assert len(images) == 2


def test_a_missing_result_is_said_plainly(tmp_path):
    done = execute(tmp_path)
    assert done.returncode != 0
    assert "results/fig7.nc is not there yet; first run: make study-fig7" in done.stderr


def test_notebook_is_stored_without_outputs():
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code)
