"""The notebooks in studies/ run from top to bottom, and give what they are stored with.

Where one is stored with something else: jupyter execute --inplace studies/NAME.ipynb.
"""

import re
from pathlib import Path

import nbformat
import pytest

from tests.support.commands import besides_notes
from tests.support.python import printed

FOLDER = Path(__file__).resolve().parents[2] / "studies"
PLOTS = {"explore": 4, "engineer": 2, "cluster": 1}  # of the notebook for each reader
NUMBER = r"-?\d+\.?\d*(?:[eE][+-]?\d+)?"
# In a process of its own: the kernel and its event loop stay out of the tests' process.
EXECUTE = """
import sys, nbclient, nbformat
notebook = nbformat.read(sys.argv[1], as_version=4)
how = {"timeout": 900, "startup_timeout": 300, "kernel_name": "python3"}
nbclient.NotebookClient(notebook, **how).execute()
nbformat.write(notebook, "executed.ipynb")
"""


def outputs_of(path):
    """Return the outputs of a valid notebook, one list per code cell."""
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    return [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]


def besides_machine_code(outputs):
    """Return the outputs without what the first one is told that needs some machine code."""

    def is_note(part):
        return part.get("name") == "stderr" and not besides_notes(part.text)

    return [[part for part in cell if not is_note(part)] for cell in outputs]


def kinds(outputs):
    """Return what each cell shows: streams by name, data by type."""
    return [[part.get("name") or sorted(part.data) for part in cell] for cell in outputs]


def text_of(outputs):
    """Return all that is printed, or shown as text."""
    parts = [part for cell in outputs for part in cell]
    shown = [part.get("text") or part.data.get("text/plain", "") for part in parts]
    return "\n".join(text for text in shown if "<Figure" not in text)


def test_every_notebook_is_tested():
    assert {path.stem for path in FOLDER.glob("*.ipynb")} == set(PLOTS)


@pytest.mark.exhaustive  # in a Jupyter kernel of its own
@pytest.mark.parametrize("name", PLOTS)
def test_it_gives_in_an_empty_folder_what_it_is_stored_with(name, tmp_path, monkeypatch):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    notebook = FOLDER / f"{name}.ipynb"
    printed("-c", EXECUTE, notebook, cwd=tmp_path)
    outputs = besides_machine_code(outputs_of(tmp_path / "executed.ipynb"))
    known = outputs_of(notebook)
    assert kinds(outputs) == kinds(known)
    now, before = (re.split(NUMBER, text_of(each)) for each in (outputs, known))
    assert [words.split() for words in now] == [words.split() for words in before]
    actual, told = ([float(n) for n in re.findall(NUMBER, text_of(o))] for o in (outputs, known))
    assert actual == pytest.approx(told, rel=0.02, abs=2e-4)


@pytest.mark.parametrize("name", PLOTS)
def test_it_is_stored_with_its_plots_and_without_warnings_or_paths_of_a_machine(name):
    outputs = outputs_of(FOLDER / f"{name}.ipynb")
    parts = [part for cell in outputs for part in cell]
    assert not [part for part in parts if part.get("name") == "stderr"]
    assert len([part for part in parts if "image/png" in part.get("data", {})]) == PLOTS[name]
    assert not re.search(r"(^|[\s'\"=])/\w", text_of(outputs))
