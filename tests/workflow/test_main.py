"""``python -m workflow`` in any folder: nothing of it is run; interrupted at any time, one line."""

import pytest

from tests.support.python import ROOT, printed, python
from tests.support.small import write_study
from tests.support.sweeps import sweep

# What the program, its workers and the start of a process import, sooner or later.
PLANTED = ("tomllib", "numpy", "distributed", "multiprocessing", "struct", "kernels", "studies")


@sweep("command", ["plan"], ["run", "--workers", "1"])  # a worker starts as a process does
def test_modules_of_the_working_folder_are_not_run_here_nor_in_workers(tmp_path, command):
    for name in PLANTED:
        (tmp_path / f"{name}.py").write_text("import os\nos._exit(77)\n")
    study = write_study(tmp_path)
    words = [*command, study, "--out", tmp_path, "--set", "grid.hurst=0.7"]
    printed("-m", "workflow", *words, cwd=tmp_path, PYTHONPATH=str(ROOT))
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
    done = python("-c", IMPATIENT, "run", "fig2")
    assert (done.returncode, done.stdout) == (130, "")
    assert done.stderr == "aborted before the start\n"


CONFIGURATIONS = {"broken": "a: [b\n  c", "a list": "- a\n- b\n"}


@pytest.mark.parametrize("text", CONFIGURATIONS.values(), ids=CONFIGURATIONS)
def test_a_configuration_of_dask_that_cannot_be_read_is_refused_before_anything_is_done(
    tmp_path, text
):
    (tmp_path / "dask.yaml").write_text(text)
    study = write_study(tmp_path)
    script = "import elastomer_friction as ef; ef.scene.run(material={}, programme=[])"
    for words in (["-m", "workflow", "run", study, "--out", str(tmp_path)], ["-c", script]):
        done = python(*words, DASK_CONFIG=str(tmp_path))
        *_, line = done.stderr.splitlines()
        assert "the settings of dask: A dask config file at" in line
        assert "UserError" in line or (done.returncode, done.stderr.count("\n")) == (2, 1)
    assert not (tmp_path / "store").exists()


LIMITED = """
import resource, runpy, sys
resource.setrlimit(resource.RLIMIT_AS, (int(sys.argv.pop(1)), resource.RLIM_INFINITY))
runpy.run_module("workflow", run_name="__main__")
"""


@pytest.mark.parametrize("size", [150_000_000, 350_000_000])
def test_a_limit_of_memory_below_that_of_the_packages_is_refused_before_they_load(size):
    done = python("-c", LIMITED, str(size), "plan", "fig2")
    assert (done.returncode, done.stderr.count("\n")) == (2, 1)
    assert f"ulimit -v = {size // 1024}: must be at least" in done.stderr


@pytest.mark.parametrize("setting", ["CONNECT=0s", "TCP=soon"])
def test_settings_of_dask_with_which_no_worker_starts_are_refused(tmp_path, setting):
    name, value = f"DASK_DISTRIBUTED__COMM__TIMEOUTS__{setting}".split("=")
    words = ["run", write_study(tmp_path), "--out", str(tmp_path), "--workers", "1"]
    done = python("-m", "workflow", *words, "--set", "study.realizations=4", **{name: value})
    assert done.returncode == 2, done.stderr
    assert "Traceback" not in done.stderr
    assert "; correct the settings of dask" in done.stderr.splitlines()[-1]
