"""What small tasks cost beside importing what they cannot do without, all of them in new processes.

    python -m tests.tools.task_costs

Ratios of CPU times of all processes. Printed by `make bench` (bench.py).
"""

import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM = ("-m", "elastomer_friction")
ONE = ("--set", "grid.velocity_step=0.2", "--set", "study.realizations=20")
TWO = ("--scale", "smoke")
TURNS = 3


def cpu_seconds(arguments: tuple[str, ...], folder: Path) -> float:
    """Return the least CPU time of Python with these arguments, with all that it starts."""
    taken = []
    for _ in range(TURNS):
        if "run" in arguments:  # what is there already would not be computed again
            shutil.rmtree(folder / "results", ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        where = {"cwd": folder, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        subprocess.run([sys.executable, *arguments], check=True, **where)  # type: ignore[call-overload]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(taken)


def task_costs() -> None:
    """Print the table."""
    print("\nSmall tasks: CPU time over that of importing what they need\n")
    print("| task | over | ratio |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        tasks = {
            "--help": (("--help",), "argparse"),
            "plan fig2": (("plan", "fig2"), "numba, numpy"),
            "run fig2, one point": (("run", "fig2", *ONE), "numba, numpy, xarray, netCDF4"),
            "run fig2, smoke": (("run", "fig2", *TWO), "numba, numpy, xarray, netCDF4"),
            "figure fig2, smoke": (("figure", "fig2", *TWO), "xarray, netCDF4, matplotlib.pyplot"),
        }
        for name, (words, needed) in tasks.items():
            bare = cpu_seconds(("-c", f"import {needed}"), folder)
            print(f"| {name} | {needed} | {cpu_seconds((*PROGRAM, *words), folder) / bare:.2f} |")


if __name__ == "__main__":
    task_costs()
