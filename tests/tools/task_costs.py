"""What small tasks cost beside importing what they cannot do without, all of them in new processes.

    python -m tests.tools.task_costs

CPU times of all processes, and their ratios. Printed by `make bench` (bench.py).
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
LARGE = ("--set", "numerics.samples=4000", "--set", "study.realizations=1000")  # 32 MB in a store
CREEP = str(Path(__file__).parents[2] / "docs" / "creep.toml")
TURNS = 3


def cpu_seconds(arguments: tuple[str, ...], folder: Path, anew: str = "") -> float:
    """Return the least CPU time of Python with these arguments, with all that it starts.

    anew : what is there of it already, and goes before every turn.
    """
    taken = []
    for _ in range(TURNS):
        if anew:
            shutil.rmtree(folder / anew, ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        where = {"cwd": folder, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        subprocess.run([sys.executable, *arguments], check=True, **where)  # type: ignore[call-overload]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(taken)


def task_costs() -> None:
    """Print the table."""
    print("\nSmall tasks: CPU-s, and the ratio to that of importing what they need, their limit\n")
    print("| task | over | CPU-s | ratio |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        computing, drawing = "numba, numpy, xarray, netCDF4", "xarray, netCDF4, matplotlib.pyplot"
        tasks = {
            "--help": (("--help",), "argparse"),
            "plan fig2": (("plan", "fig2"), "numba, numpy"),
            "run fig2, one point": (("run", "fig2", *ONE), computing),
            "run fig2, smoke": (("run", "fig2", *TWO), computing),
            "figure fig2, smoke": (("figure", "fig2", *TWO), drawing),
            "animate docs/creep.toml": (("animate", CREEP), f"numba, {drawing}"),
            "run fig2, 1000 lines": (("run", "fig2", *LARGE), computing),
        }
        for name, (words, needed) in tasks.items():
            bare = cpu_seconds(("-c", f"import {needed}"), folder)
            taken = cpu_seconds((*PROGRAM, *words), folder, "results" if "run" in words else "")
            print(f"| {name} | {needed} | {taken:.2f} | {taken / bare:.2f} |")
        merge = (*PROGRAM, "merge", "results", "other")
        first, again = cpu_seconds(merge, folder, "other"), cpu_seconds(merge, folder)
        print(f"| merge these again | the first time | {again:.2f} | {again / first:.2f} |")


if __name__ == "__main__":
    task_costs()
