"""`make bench`: cost of the program compared with other programs, and cost of its effects.

Times are the smallest of several CPU times; ratios are of times measured in turns in one run.
Compare them with each other, not between machines. For the cost of accuracy see `make
study-accuracy`.
"""

import contextlib
import math
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from elastomer_friction.kernels import (
    KELVIN,
    SCHEMES,
    Case,
    ConstantForce,
    Hold,
    Line,
    Oscillation,
    Quantities,
    Ramp,
    SceneCase,
    Slide,
    lagged_slope,
    march,
    run_case,
    run_scene,
    scene_steps,
    steady_sliding,
)
from elastomer_friction.kernels.drive import Drive, run_pulled
from elastomer_friction.kernels.half_space.scenes import run_scene_on_half_space
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.heat.heat import Heat
from elastomer_friction.kernels.interface.effects import Effects
from elastomer_friction.kernels.interface.layer import BONDED, Layer
from elastomer_friction.kernels.interface.shear import Bell, ShearLaw
from elastomer_friction.kernels.rheology.time_shift import Wlf
from elastomer_friction.studies.stability.probe import random_line
from tests.tools.rivals.compiled import Compiled
from tests.tools.rivals.rows import (
    HURST,
    LOAD,
    SPEED,
    TURNS,
    M,
    a_scene,
    branches,
    in_turns,
    print_contacts,
    print_scenes,
    print_velocity_steps,
)

ELEMENTS = 500  # elements of the line of scenes
SLIDE = (Slide(SPEED, 100.0),)
MARCHED = round(100.0 * M)  # number of steps
REPEATS, ONCE = 10, 1e-9  # number of turns; seconds per turn so small that a turn is one call
ALL_SAMPLES = "march, all samples"
STEP_ELEMENTS, LINES = 2000, 8  # elements of a line, and number of lines, in velocity steps
POINTS = {  # name: (H, Fbar, x)
    "H = 0.7, x = 17": (0.7, 0.05, 17.0),
    "H = 0.3, x = 50": (0.3, 0.05, 50.0),
    "H = 0.7, x = 1": (0.7, 0.05, 1.0),
}
EVERYTHING = "steady states, jump, relaxation"
EFFECTS = {
    "steady states": Quantities(True, False, False),
    "steady states, jump": Quantities(True, True, False),
    EVERYTHING: Quantities(),
    "the same, indentation rate dropped": Quantities(indentation_rate=False),
}
MAP_ELEMENTS, MAP_BRANCHES = 64, (1, 5, 13)  # of a side of a map, and of the material on it
SHEAR = ShearLaw(Bell(1.0, SPEED, 1.2))
HEAT = Heat(0.4, 0.5, 0.0, Wlf(8.86, 101.6, 20.0), 20.0, 0.01)  # no step warms by 1 K
MAP_EFFECTS = {
    "none": Effects(),
    "shear": Effects(shear=SHEAR),
    "heat": Effects(heat=HEAT),
    "shear, heat of a block": Effects(shear=SHEAR, heat=HEAT._replace(block=5.0)),
    "layer": Effects(layer=Layer(10.0, BONDED, 0.5)),
}
CREEP = str(Path(__file__).parents[2] / "docs" / "creep.toml")
TASKS = {  # name: modules that it needs, arguments of the command
    "--help": ("argparse", ("--help",)),
    "run fig2": ("numba, numpy, xarray, netCDF4", ("run", "fig2", "--scale", "smoke")),
    "figure fig2": (
        "xarray, netCDF4, matplotlib.pyplot",
        ("figure", "fig2", "--scale", "smoke"),
    ),
    "animate docs/creep.toml": (
        "numba, xarray, netCDF4, matplotlib.pyplot",
        ("animate", CREEP),
    ),
}


def cpu_seconds(arguments: tuple[str, ...], folder: Path) -> float:
    """Return the smallest CPU time of Python with these arguments, with its child processes."""
    seconds = []
    for _ in range(TURNS):
        if "run" in arguments:
            shutil.rmtree(folder / "results", ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, *arguments], cwd=folder, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(seconds)


def print_tasks() -> None:
    """Print the cost of small tasks, compared with importing the modules that they need."""
    print("\nSmall tasks in new processes: CPU-s, and the ratio to that of importing\n")
    print("| task | imports | CPU-s | ratio |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as place:
        for name, (needed, words) in TASKS.items():
            bare = cpu_seconds(("-c", f"import {needed}"), Path(place))
            seconds = cpu_seconds(("-m", "elastomer_friction", *words), Path(place))
            print(f"| {name} | {needed} | {seconds:.2f} | {seconds / bare:.2f} |", flush=True)


def print_drives() -> None:
    """Print the cost of a programme with a spring, over that of the same programme without."""
    print(f"\nPull over slide (N = {ELEMENTS}, m = {M})\n")
    print("| material | stiff spring, slides through | soft spring, creeps |\n|---|---|---|")
    line = random_line(HURST, ELEMENTS, M, 1, 0)
    rms_slope = math.sqrt(float(np.mean(line.slope**2)))
    for name, spectrum in (("Kelvin", KELVIN), ("K = 13", branches(13))):
        ratios = []
        for stiffness, start in ((1.0, "steady"), (2e-3, "relaxed")):  # over load times slope
            scene = a_scene(SLIDE, spectrum, start=start)
            drive = Drive(stiffness * LOAD * rms_slope)
            pulled = partial(run_pulled, line, scene, drive)
            pull, slide = in_turns((pulled, partial(run_scene, line, scene)), REPEATS, ONCE)
            ratios.append(pull / slide)
        print(f"| {name} | {ratios[0]:.2f} | {ratios[1]:.2f} |")


def plain_march(line: Line) -> Callable[[], object]:
    """Return a march of Kelvin elements over all samples, as long as SLIDE."""
    law = SCHEMES["exponential"](1.0 / (M * SPEED))
    load = LOAD * line.z.size
    state, _ = steady_sliding(law, line.z, load)
    weight = lagged_slope(line.slope, law.lag)
    recorded = np.unique(np.linspace(1, MARCHED, 64, dtype=int))
    return partial(march, law, ConstantForce(load), line.z, weight, state, recorded, math.inf)


def scenes() -> dict[str, tuple[Line, SceneCase, str]]:
    """Return (line, scene, name of the scene it is compared with) by effect."""
    line, one = random_line(HURST, ELEMENTS, M, 1, 0), branches(1)
    kelvin, slide = "general path, Kelvin", "slide, K = 1"
    held = {"load": math.nan, "indentation": 1.0}
    frames = {"requested": ("trace", "snapshots"), "frames": np.arange(64)}
    lengths = {
        "requested": ("trace", "contact_lengths"),
        "edges": np.array([0.0, 1.0, 2.0, 4.0, 8.0, 1000.0]),
    }
    return {
        kelvin: (line, a_scene(SLIDE, KELVIN), ALL_SAMPLES),
        slide: (line, a_scene(SLIDE, one), kelvin),
        "slide, K = 5": (line, a_scene(SLIDE, branches(5)), kelvin),
        "slide, K = 13": (line, a_scene(SLIDE, branches(13)), kelvin),
        "relaxation form": (line, a_scene(SLIDE, one, scheme="implicit-euler"), slide),
        "hold": (line, a_scene((Slide(SPEED, 5.0), Hold(1e6)), one), slide),
        "reversal": (line, a_scene((Slide(SPEED, 50.0), Slide(-SPEED, 50.0)), one), slide),
        "small oscillation": (line, a_scene((Oscillation(0.0, 0.02, 1.0, 6),), one), slide),
        "ramp": (line, a_scene((Ramp(SPEED, 3.0 * SPEED, 10.0),), one), slide),
        "prescribed indentation": (line, a_scene(SLIDE, one, **held), slide),
        "energy": (line, a_scene(SLIDE, one, requested=("trace", "energy")), slide),
        "contact lengths": (line, a_scene(SLIDE, one, **lengths), slide),
        "64 snapshots": (line, a_scene(SLIDE, one, **frames), slide),
        "no trace": (line, a_scene(SLIDE, one, requested=()), slide),
        "measured line": (Line.measured(line.z[::M], M), a_scene(SLIDE, one), slide),
    }


def print_effects_of_scenes() -> None:
    """Print the cost of a step of every scene, over that of the scene it is compared with."""
    compared = scenes()
    runs: dict[str, Callable[[], object]] = {
        name: partial(run_scene, line, scene) for name, (line, scene, _) in compared.items()
    }
    steps = {name: scene_steps(scene, M).dt.size for name, (_, scene, _) in compared.items()}
    runs[ALL_SAMPLES] = plain_march(random_line(HURST, ELEMENTS, M, 1, 0))
    steps[ALL_SAMPLES] = MARCHED
    times = in_turns(runs.values(), REPEATS, ONCE)
    seconds = {name: s / steps[name] for name, s in zip(runs, times, strict=True)}
    print(f"\nWhat a step of a scene costs (N = {ELEMENTS}, m = {M})\n")
    print("| effect | ratio | to |\n|---|---|---|")
    for name, (_, _, other) in compared.items():
        print(f"| {name} | {seconds[name] / seconds[other]:.2f} | {other} |")


def print_effects_on_maps() -> None:
    """Print the cost of a slide on a half-space with every effect, over that without effects."""
    side, legs = MAP_ELEMENTS * M, (Slide(SPEED, 32.0),)
    print(f"\nWhat effects cost on a half-space ({side}^2 samples, K branches)\n")
    print("| effects |", " | ".join(f"K = {count}" for count in MAP_BRANCHES), "|")
    print("|---|" + "---|" * len(MAP_BRANCHES))
    amplitudes = ring_amplitudes(HURST, MAP_ELEMENTS)
    surface = Surface.drawn(np.random.default_rng(1), amplitudes, MAP_ELEMENTS, M)
    columns = []
    for count in MAP_BRANCHES:
        scene = a_scene(legs, branches(count))
        scenes = [scene._replace(effects=effects) for effects in MAP_EFFECTS.values()]
        runs = [partial(run_scene_on_half_space, surface, scene) for scene in scenes]
        seconds = in_turns(runs, TURNS, ONCE)
        columns.append([f"{value / seconds[0]:.2f}" for value in seconds])
    for name, ratios in zip(MAP_EFFECTS, zip(*columns, strict=True), strict=True):
        print(f"| {name} |", " | ".join(ratios), "|", flush=True)


def run_lines(lines: list[Line], case: Case, quantities: Quantities) -> None:
    """Run a velocity step on all lines."""
    for line in lines:
        run_case(line, case, quantities)


def print_effects_of_steps() -> None:
    """Print the cost of a velocity step for several sets of quantities, over that of all."""
    print(f"\nWhat effects cost (m = {M}), relative to {EVERYTHING}")
    for point, (hurst, load, x) in POINTS.items():
        lines = [random_line(hurst, STEP_ELEMENTS, M, seed, 0) for seed in range(LINES)]
        span = 1.5 / x ** (1.0 - hurst) * 1.2 * x / math.pi  # in dx, 1.5 tau/b
        kept_steps = np.unique(np.ceil(np.linspace(span / 16, span, 16) * M).astype(np.int64))
        case = Case(load, x / math.pi, (1.2,), (kept_steps,), "exponential")
        runs = [partial(run_lines, lines, case, quantities) for quantities in EFFECTS.values()]
        seconds = dict(zip(EFFECTS, in_turns(runs, TURNS, 0.1), strict=True))
        print(f"\n{point}")
        for name, value in seconds.items():
            print(f"  {name:40s}{value / seconds[EVERYTHING]:6.2f}")


def main() -> None:
    """Print all tables; those that compare with C need a compiler."""
    with contextlib.suppress(FileNotFoundError):
        compiled = Compiled()
        print_velocity_steps(compiled)
        print_scenes(compiled)
    print_contacts()
    print_tasks()
    print_effects_of_steps()
    print_effects_of_scenes()
    print_effects_on_maps()
    print_drives()


if __name__ == "__main__":
    main()
