"""Jobs of a batch system: asked for as the table [cluster] says; what is refused is one line."""

import os
import shlex
import subprocess

import pytest
from distributed.security import Security

from elastomer_friction.workflow.cluster import jobs as slurm
from elastomer_friction.workflow.cluster.security import new_security
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.cluster import OMISSIBLE_DIRECTIVES, Cluster
from tests.support.documents import CLUSTER

LINES = (
    "#SBATCH -p normal",
    "#SBATCH -A friction",
    "#SBATCH --cpus-per-task=4",
    "#SBATCH -t 02:00:00",
    "#SBATCH --qos=long",
    "export OMP_NUM_THREADS=1",
    "export NUMBA_NUM_THREADS=1",
    "module load python",
    "export DASK_DISTRIBUTED__A__B='[]'",
    "export PYTHONSAFEPATH=1",
    "export DASK_TEMPORARY_DIRECTORY=$(mktemp -d)",
)
OPTIONS = (
    "'/a folder/python' -m ",
    "--nthreads 1",
    "--nworkers 4",
    "--interface ib0",
    "--lifetime 6480s --lifetime-stagger 648s",
    "--no-dashboard",
    "--protocol tls://",
    "--tls-ca-file a --tls-cert c --tls-key k",
)


def test_jobs_are_asked_for_as_the_table_says(tmp_path, monkeypatch):
    from dask_jobqueue.slurm import SLURMJob

    monkeypatch.setattr(slurm.sys, "executable", "/a folder/python")
    monkeypatch.setattr(slurm, "interface_named", str)  # ib0 need not be there
    given = CLUSTER | {"log_folder": str(tmp_path)}  # which is made
    settings = slurm._settings(Cluster(**given), {"distributed.a.b": []})
    settings["security"] = Security(tls_ca_file="a", tls_worker_cert="c", tls_worker_key="k")
    script = SLURMJob("tls://here:1", "name", **settings).job_script()
    assert set(LINES) <= set(script.splitlines())
    above = script.partition("export")[0].splitlines()
    directives = [line for line in script.splitlines() if line.startswith("#SBATCH")]
    assert [line for line in above if line][1:] == directives  # above all commands
    assert not any("--mem" in line or "--no-requeue" in line for line in directives)
    for option in OPTIONS:
        assert option in script


def test_jobs_have_the_usual_directives_unless_some_are_left_out(tmp_path):
    from dask_jobqueue.slurm import SLURMJob

    given = {"where": "slurm", "log_folder": str(tmp_path)}
    settings = slurm._settings(Cluster(**given), {})
    settings["security"] = Security(tls_ca_file="a", tls_worker_cert="c", tls_worker_key="k")
    script = SLURMJob("tls://here:1", "-n", **settings).job_script()
    written = {line.split()[1].partition("=")[0] for line in script.splitlines() if "#SB" in line}
    assert written == set(OMISSIBLE_DIRECTIVES) - {"-p", "-A"}  # neither queue nor account
    fewer = slurm._settings(Cluster(**(given | {"leave_out": ["-n"]})), {})
    fewer["security"] = settings["security"]
    shorter = SLURMJob("tls://here:1", "-n", **fewer).job_script()
    lines = set(script.splitlines()) - set(shorter.splitlines())
    assert lines == {"#SBATCH -n 1"}


@pytest.mark.parametrize(
    "name", ["a b", "l$(touch pwned)", "l;touch pwned", "l`touch pwned`", "ü&'\"\\%j"]
)
def test_paths_of_any_letters_reach_the_workers_of_a_job(name, tmp_path, monkeypatch):
    from dask_jobqueue.slurm import SLURMJob

    folder = tmp_path / name
    folder.mkdir()
    python = folder / "python"  # instead of a worker, it writes its arguments
    python.write_text('#!/bin/bash\nprintf "%s\\0" "$@" > "$ARGUMENTS"\n')
    python.chmod(0o700)
    monkeypatch.setattr(slurm.sys, "executable", str(python))
    given = CLUSTER | {"log_folder": str(folder), "interface": "lo", "prologue": []}
    settings = slurm._settings(Cluster(**given), {"distributed.a.b": str(folder)})
    security = new_security(str(folder), quoted=True)
    script = SLURMJob("tls://here:1", "name", security=security, **settings).job_script()
    written = tmp_path / "arguments"
    environment = {"PATH": os.environ["PATH"], "ARGUMENTS": str(written), "PYTHONPATH": ""}
    subprocess.run(["bash"], input=script, text=True, cwd=tmp_path, env=environment, check=True)
    assert not (tmp_path / "pwned").exists()
    arguments = written.read_text().split("\0")
    assert arguments[arguments.index("--tls-ca-file") + 1] == str(folder / "run.pem")
    output = {
        line.split('"')[0]: shlex.split(line)[-1] for line in script.splitlines() if "%J" in line
    }
    place = str(folder).replace("%", "%%")
    assert output == {
        "#SBATCH -e ": f"{place}/dask-worker-%J.err",
        "#SBATCH -o ": f"{place}/dask-worker-%J.out",
    }


REFUSING = '#!/bin/bash\nread line\necho "error: $line" >&2\nexit 1\n'
REFUSALS = {"": "sbatch is not found", REFUSING: "SLURM refuses the jobs: error: queue; cluster"}


@pytest.mark.parametrize(("sbatch", "refusal"), REFUSALS.items(), ids=["missing", "refusing"])
def test_a_submission_that_fails_is_one_line(tmp_path, monkeypatch, sbatch, refusal):
    if sbatch:
        (tmp_path / "sbatch").write_text(sbatch)
        (tmp_path / "sbatch").chmod(0o700)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(UserError, match=refusal):
        slurm._try_submitting("slurm", "queue\n")


def test_an_interface_that_is_not_there_is_named(tmp_path):
    logs = tmp_path / "new" / "logs"
    given = Cluster(**(CLUSTER | {"interface": "no-such0", "log_folder": str(logs)}))
    refusal = r"cluster\.interface = 'no-such0': .* from .*lo"
    with pytest.raises(UserError, match=refusal), slurm.job_cluster(None, given):
        pass
    assert list(logs.iterdir()) == []  # the folder was made, and its key is gone
