"""A private SLURM of two emulated nodes on loopback: no systemd, no cgroups, no database.

``python -m tests.cluster.slurm [STUDY …]`` runs a study in its jobs: `make try-slurm`.
"""

import getpass
import itertools
import os
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil

from tests.cluster.processes import PATIENCE, free_port, kill, workers_of

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel", "sinfo")
NODES = ("n1", "n2")
CONFIGURATION = """\
ClusterName=private
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ctld_port}
SlurmdPort={slurmd_port}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmUser={user}
SlurmdUser={user}
AuthInfo=socket={short}/run/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/ctld
SlurmdSpoolDir={short}/spool/%n
SlurmctldPidFile={short}/run/slurmctld.pid
SlurmdPidFile={short}/run/slurmd-%n.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=100000
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=5
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={n1} CPUs=1 RealMemory=4000 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={n2} CPUs=1 RealMemory=4000 State=UNKNOWN
PartitionName=normal Nodes=n1,n2 Default=YES MaxTime=01:00:00 DefMemPerCPU=512 State=UP
"""


def missing() -> str:
    """Return why SLURM cannot be started here, or nothing."""
    absent = [name for name in PROGRAMS if shutil.which(name, path=_path()) is None]
    if absent:
        return f"not installed: {', '.join(absent)}"
    return "" if os.geteuid() == 0 else "only root can start a private SLURM"


def _path() -> str:
    return f"{os.environ['PATH']}:/usr/sbin:/sbin"


class Slurm:
    """Two nodes of one core each; commands find it by the environment of this process."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.short = Path(tempfile.mkdtemp(prefix="slurm-", dir="/tmp"))  # sockets: 107 letters
        for name in ("ctld", "log", "jobs"):
            (folder / name).mkdir(parents=True)
        for name in ("run", *(f"spool/{node}" for node in NODES)):
            (self.short / name).mkdir(parents=True)
        self.environment = {"SLURM_CONF": str(folder / "slurm.conf"), "PATH": _path()}
        ports = {name: free_port() for name in ("ctld_port", "slurmd_port", *NODES)}
        host = socket.gethostname().partition(".")[0]
        places = {"folder": folder, "short": self.short}
        text = CONFIGURATION.format(host=host, user=getpass.getuser(), **places, **ports)
        (folder / "slurm.conf").write_text(text)
        self._start()

    @property
    def table(self) -> dict[str, str | int]:
        """The keys of [cluster] for jobs of this SLURM."""
        keys = {"queue": "normal", "jobs": 2, "memory": "1500MB", "walltime": "00:30:00"}
        return keys | {"interface": "lo", "log_folder": str(self.folder / "jobs")}

    def options(self) -> list[str]:
        """Return the options of a run that computes in jobs of this SLURM."""
        settings = (("--set", f"cluster.{key}={value!r}") for key, value in self.table.items())
        return ["--slurm", *itertools.chain(*settings)]

    def run(self, *command: str, check: bool = True) -> str:
        """Run a command of SLURM and return what it prints."""
        environment = {**os.environ, **self.environment}
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
        if check and done.returncode:
            raise RuntimeError(f"{command}: {done.stderr}")
        return done.stdout

    def set_down(self, node: str) -> bool:
        """Take a node away with whatever runs there."""
        self.run("scontrol", "update", f"NodeName={node}", "State=DOWN", "Reason=chaos")
        return True

    def stop_controller(self) -> None:
        """End what takes in and gives out jobs; those that run go on."""
        pid = int((self.short / "run" / "slurmctld.pid").read_text())
        kill(pid, signal.SIGTERM)
        while psutil.pid_exists(pid):
            time.sleep(0.1)

    def start_controller(self) -> None:
        """Start it again, with what it knew."""
        self.run("slurmctld", "-f", self.environment["SLURM_CONF"])

    def heal(self) -> None:
        """Give back nodes that are down; one may come back by itself meanwhile."""
        for node in filter(self._away, NODES):
            try:
                self.run("scontrol", "update", f"NodeName={node}", "State=RESUME")
            except RuntimeError:  # "Invalid node state"
                if self._away(node):
                    raise

    def _away(self, node: str) -> bool:
        state = self.run("sinfo", "-h", "-n", node, "-o", "%T").strip()
        return state.startswith(("down", "drain"))

    def nannies(self) -> list[psutil.Process]:
        """Return the processes that jobs run: nannies of our nodes alone."""
        actual = []
        for process in psutil.process_iter():
            try:
                ours = process.environ().get("SLURM_CONF") == self.environment["SLURM_CONF"]
                if ours and "distributed.cli.dask_worker" in process.cmdline():
                    actual.append(process)
            except psutil.Error:
                continue
        return actual

    def workers(self) -> list[int]:
        """Return the pids of the worker processes in the jobs."""
        return [pid for nanny in self.nannies() for pid in workers_of(nanny)]

    def stop(self) -> None:
        """End all jobs and daemons."""
        self.run("scancel", "--user", getpass.getuser(), check=False)
        end = time.monotonic() + PATIENCE
        while self.run("squeue", "-h", check=False).strip() and time.monotonic() < end:
            time.sleep(0.5)  # a node does not end before it has told of its jobs
        for nanny in self.nannies():
            for pid in (*workers_of(nanny), nanny.pid):
                kill(pid, signal.SIGKILL)
        pids = [int(file.read_text()) for file in (self.short / "run").glob("*.pid")]
        daemons = [psutil.Process(pid) for pid in pids if psutil.pid_exists(pid)]
        for daemon in daemons:
            kill(daemon.pid, signal.SIGTERM)
        psutil.wait_procs(daemons, timeout=PATIENCE)  # they write as they end
        shutil.rmtree(self.short, ignore_errors=True)

    def _start(self) -> None:
        run, key = self.short / "run", self.short / "run" / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        run.chmod(0o755)
        files = {"socket": "munge.socket", "pid-file": "munged.pid", "log-file": "munged.log"}
        files |= {"key-file": key.name, "seed-file": "munge.seed"}
        options = (f"--{option}={run / name}" for option, name in files.items())
        self.run("munged", "--force", "--num-threads=2", *options)
        configuration = self.environment["SLURM_CONF"]
        self.run("slurmctld", "-c", "-f", configuration)
        for node in NODES:
            self.run("slurmd", "-f", configuration, "-N", node)
        end = time.monotonic() + PATIENCE
        while self.run("sinfo", "-h", "-o", "%T", check=False).strip() != "idle":
            if time.monotonic() > end:
                raise RuntimeError("the nodes of the private SLURM do not come up")
            time.sleep(0.25)


def main() -> None:
    """Run a study in jobs of a private SLURM, and end it."""
    if reason := missing():
        sys.exit(f"{reason}; on Debian: apt install slurmctld slurmd slurm-client munge")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    with tempfile.TemporaryDirectory(prefix="slurm-") as place:
        slurm = Slurm(Path(place) / "private")
        try:
            study = sys.argv[1:] or ["fig7", "--scale", "smoke"]
            command = [sys.executable, "-m", "workflow", "run", *study, *slurm.options()]
            print(shlex.join(command), flush=True)
            status = subprocess.run(command, env=os.environ | slurm.environment).returncode
        finally:
            slurm.stop()
    sys.exit(status)


if __name__ == "__main__":
    main()
