"""The notebook studies/explore.ipynb runs from top to bottom on a small result."""

import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

executed = pytest.mark.exhaustive  # in a Jupyter kernel of its own, on the result of figure 7
NOTEBOOK = Path(__file__).resolve().parents[2] / "studies" / "explore.ipynb"
# In a process of its own: the kernel and its event loop stay out of the tests' process.
EXECUTE = """
import sys, nbclient, nbformat
notebook = nbformat.read(sys.argv[1], as_version=4)
nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
nbformat.write(notebook, "executed.ipynb")
"""


@pytest.fixture(scope="module")
def outputs(fig7, fig7_folder):
    """Return the outputs of the notebook beside the result, one list per code cell."""
    folder = fig7_folder.parent
    command = [sys.executable, "-c", EXECUTE, str(NOTEBOOK)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=200)
    assert done.returncode == 0, done.stderr
    return [cell.outputs for cell in code(folder / "executed.ipynb")]


def code(path):
    """Return the code cells of a notebook."""
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


@pytest.fixture(scope="module")
def printed(outputs):
    """Return all printed text."""
    return "".join(part.text for cell in outputs for part in cell if "text" in part)


@executed
def test_every_cell_runs_without_warnings_and_both_plots_are_drawn(outputs):
    parts = [part for cell in outputs for part in cell]
    assert not [part for part in parts if part.get("name") == "stderr"]
    assert len([part for part in parts if "image/png" in part.get("data", {})]) == 2


@executed
def test_units_and_origin_are_shown(printed):
    assert "indentation      [m] steady indentation d at v1" in printed
    assert "seed: 2014" in printed


@executed
def test_the_fit_agrees_with_the_stored_rate(printed):
    (line,) = [line for line in printed.splitlines() if line.startswith("b = ")]
    here, stored = float(line.split()[2]), float(line.split()[5])
    assert here == pytest.approx(stored, rel=1e-3)


def test_a_missing_result_is_said_plainly(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileNotFoundError, match="is not there yet; first run: make study-fig7"):
        exec(code(NOTEBOOK)[0].source, {})


def test_notebook_is_stored_without_outputs():
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code(NOTEBOOK))
