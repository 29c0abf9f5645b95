"""``python -m workflow`` in any folder: nothing of it is run; interrupted at any time, one line."""

import os
import subprocess
import sys

from tests.support.runs import PATIENCE, ROOT
from tests.support.small import write_study
from tests.support.sweeps import sweep

# What the program, its workers and the start of a process import, sooner or later.
PLANTED = ("tomllib", "numpy", "distributed", "multiprocessing", "struct", "kernels", "studies")


@sweep("command", ["plan"], ["run", "--workers", "1"])  # a worker starts as a process does
def test_modules_of_the_working_folder_are_not_run_here_nor_in_workers(tmp_path, command):
    for name in PLANTED:
        (tmp_path / f"{name}.py").write_text("import os\nos._exit(77)\n")
    study = write_study(tmp_path)
    words = [study, "--out", str(tmp_path), "--set", "grid.hurst=0.7"]
    done = subprocess.run(
        [sys.executable, "-m", "workflow", *command, *words],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "small.nc").is_file() == ("run" in command)


IMPATIENT = """
import runpy, sys
class CtrlC:
    def find_spec(self, name, *_):
        if name == "elastomer_friction.workflow.cli.commands":
            raise KeyboardInterrupt
sys.meta_path.insert(0, CtrlC())
runpy.run_module("workflow", run_name="__main__")
"""


def test_ctrl_c_while_packages_are_imported_is_one_line():
    words = [sys.executable, "-c", IMPATIENT, "run", "fig2"]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout) == (130, "")
    assert done.stderr == "aborted before anything was begun\n"
