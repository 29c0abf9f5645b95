"""The command ``animate``: one line of a scene on its way, as a gif or mp4 file."""

import argparse
from pathlib import Path

from .. import report, scene
from ..study import read_scene
from ..system import make_folder

DONE = 0
SHOWN = ["trace", "snapshots"]  # what an animation is drawn from


def add_animate_options(command: argparse.ArgumentParser) -> None:
    """Add what only the command ``animate`` is told."""
    command.add_argument("--out", help="the .gif or .mp4 file (results/NAME.gif)")


def run_animate(options: argparse.Namespace) -> int:
    """Compute the first line of a scene in this process and draw it; return the exit status."""
    study = read_scene(options.study, options.scale, options.set, SHOWN)
    path = Path(options.out or f"results/{study.name}.gif")
    report.check_animation(path)
    make_folder(path.parent)
    print(report.animate(scene.computed(study), path))
    return DONE
