"""The small study that tests of the workflow share, and variations of it."""

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.batches import cut, make_batches, missing_work
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.simulate.tasks import PHASES, SCALARS, BatchResult
from elastomer_friction.workflow.study.read import read_study
from elastomer_friction.workflow.system import Maker

MAKER = Maker("python 3, numpy 2", "a processor")

TEXT = """
[study]
title = "small"
seed = 1
realizations = 16

[material]
shear_modulus = 1e7
relaxation_time = 1e-3

[surface]
length = 0.01

[grid]
hurst = [0.3, 0.7]
normal_force = [0.04, 0.4]
spacing = 1e-4
roughness = 1e-5
velocity = [0.03, 0.1]
velocity_step = 0.2

[numerics]
samples = 16

[compare.coarse]
scheme = "implicit-euler"
steps_per_spacing = 1

[scales.wide.grid]
normal_force = [0.04, 0.4, 4.0]
"""

# Settings of two slides with a hold between them, and a study at two temperatures for them.
PROGRAMME = (
    "scene.programme=[{slide={ratio=1.0, distance=1e-3}}, {hold={duration=[1e-3, 1e-2]}}, "
    "{slide={ratio=2.0, distance=1e-3}}]"
)
HOLDING = """
[study]
seed = 1
realizations = 4
[material]
shear_modulus = 1e7
branches = [[2e7, 1e-3]]
wlf = {c1 = 10.0, c2 = 50.0, reference = 20.0}
temperature = [10.0, 20.0]
[surface]
length = 0.01
[grid]
hurst = 0.5
normal_force = 0.04
spacing = 1e-4
roughness = 1e-5
velocity = [0.03, 9.486832980505138]
[scene]
quantities = ["steady", "trace"]
"""

HEIGHTS = (3, 0, -4, -1, 2, 5, 1, -2, -3, 4)
SMOOTH = (0, 2, 4, 5, 5, 4, 2, 0, -1, -1)


def line_text(heights=HEIGHTS, header="x (um), z (nm)", skip=None):
    """Return a measured line as text; ``skip`` leaves out a sample."""
    rows = [f"{x}, {z}" for x, z in enumerate(heights) if x != skip]
    return "\n".join([header, *rows])


def spectrum_text(q=(500, 5000, 50000), unit="m^4", exponent=-3.4, size=1.3e-7):
    """Return a power spectrum as text, a power law of q."""
    rows = [f"{k}, {size * float(k) ** exponent:.6e}" for k in q]
    return "\n".join([f"q [1/m], C [{unit}]", *rows])


FILES = {  # contents of the files beside small.toml, by name
    "line.csv": line_text(),
    "two.csv": "x (um), z (nm), w (nm)\n"
    + "".join(f"{x}, {z}, {x - z * z}\n" for x, z in enumerate(SMOOTH)),
    "bare.csv": line_text(header=""),
    "gap.csv": line_text(skip=6),
    "broken.csv": line_text((*HEIGHTS, "---")),
    "flat.csv": line_text(range(10)),
    "short.csv": line_text(HEIGHTS[:7]),
    "smooth.csv": line_text(SMOOTH),
    "hole.csv": line_text((1, "nan", *HEIGHTS[2:])),
    "holes.csv": line_text((1, 2, 3, 4, *["nan"] * 6)),
    "spiky.csv": line_text((3, 0, 7000, "nan", *HEIGHTS[4:])),
    "scaled.csv": "z scale: 10\n" + line_text(HEIGHTS, "x (um), z (um)"),
    "unknown.csv": line_text(HEIGHTS, "x (um), z (V)"),
    "twice.csv": "x (um), z (nm)\n" + "".join(f"{n % 5}, {z}\n" for n, z in enumerate(HEIGHTS)),
    "steps.csv": "".join(f"{n}, {2 * n}, {z}\n" for n, z in enumerate(HEIGHTS)),
    "heights.csv": "z (nm)\n" + "".join(f"{z}\n" for z in HEIGHTS),
    "unplaced.csv": line_text().replace("3, -1", ", -1"),
    "many.csv": "x (um), a (nm), b (nm)\n" + "".join(f"{n}, {n * n}, 1\n" for n in range(9)),
    "channels.csv": ("1 5 2 8 3 9 4 7 1\n" * 9 + "# Phase\n") * 2,
    "packed.csv": "PK\x03\x04",
    "power.csv": spectrum_text(),
    "falling.csv": spectrum_text((5000, 500, 50000)),
    "equal.csv": spectrum_text((500, 5000, 5000, 50000)),
    "part.csv": spectrum_text((500, 5100, 50000)),
    "narrow.csv": spectrum_text((700, 1200)),
    "lone.csv": spectrum_text((500,)),
    "torn_power.csv": spectrum_text() + "\n60000, nan",
    "cut.csv": spectrum_text(unit="m^3", exponent=-2.4),
    "rising.csv": spectrum_text(unit="m^3", exponent=2.4),
    "branches.csv": "modulus [Pa], time [s]\n5e6, 1e-2\n1e7, 1e-3\n",
    "velocity.csv": "time velocity\n0 0.1\n1e-3 0.2\n",
    "still.csv": "0 0\n1 0\n",
    "far.csv": "0 1\n1e9 1\n",
    "back.csv": "0 0.1\n1 0.2\n1 0.1\n",
    "one.csv": "0 0.1\n",
    "three.csv": "1, 2, 3\n",
    "torn.csv": "0 0.1\n1 nan\n2 0.1\n",
    "shares.csv": "alpha, tau\n0.5, 1\n0.6, 2\n",
    "tiny.csv": "0.1, 1\n0.2, 2\n",
    "unknown_branch.csv": "modulus [Pa], time [s]\n5e6, nan\n1e7, 1\n",
    "words.csv": "time velocity\n",
    "minus.csv": "temperature (°C), -log a_T\n50, 1.5\n20, 0\n0, -2\n",
    "shifts.csv": "temperature (°C), log a_T\n50, -1.5\n20, 0\n0, 2\n",
    "shear.csv": "velocity (mm/s), shear stress (MPa)\n1, 2\n10, 3\n",
    "shear_falling.csv": "velocity (m/s), stress (Pa)\n1, 2\n1, 3\n",
    "shear_negative.csv": "velocity (m/s), stress (Pa)\n1, 2\n2, -3\n",
    "factors.csv": "T (°C), a_T\n0, 10\n20, 0\n",
}


def write_study(folder, text=TEXT):
    """Write small.toml and FILES into ``folder``; return the path of small.toml as a string."""
    for name, content in FILES.items():
        (Path(folder) / name).write_text(content, encoding="utf-8")
    path = Path(folder) / "small.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def small_study(*settings, text=TEXT, scale=None):
    """Return the small study with --set ``settings``, whose file is always the same."""
    with tempfile.TemporaryDirectory() as folder:
        study = read_study(write_study(folder, text), scale, list(settings))
    return replace(study, folder=Path(tempfile.gettempdir()))


def complaint(*settings, **how):
    """Return the one-line error of the small study with ``settings``, from reading or planning."""
    with pytest.raises(UserError) as error:
        small_plan(*settings, **how)
    message = str(error.value)
    assert "\n" not in message
    return message


def small_plan(*settings, **how):
    """Return the plan of the small study with --set ``settings``."""
    return make_plan(small_study(*settings, **how))


def cut_batches(plan, stored=(), target=1.0, blocks=None):
    """Yield batches of about ``target`` predicted seconds for all records not in ``stored``."""
    return make_batches(cut(missing_work(plan, stored, blocks), target), target)


def keys(plan):
    """Return the keys of the tasks of the first variant, the study itself, in order."""
    return [task.key for task in plan.variants[0].tasks]


def all_records(plan):
    """Return every record (key, block) of a plan."""
    blocks = range(plan.study.blocks)
    return [(t.key, block) for v in plan.variants for t in v.tasks for block in blocks]


def random_result(batch, seed=0):
    """Return a result of the right shape with random numbers and a NaN tail."""
    rng = np.random.default_rng(seed)
    shape = (len(batch.tasks), batch.blocks)
    curves = rng.standard_normal((*shape, batch.recording.samples - 1))
    curves[..., -2:] = np.nan
    spent = np.full((len(batch.tasks), len(PHASES)), 0.01)
    return BatchResult(
        rng.standard_normal((*shape, len(SCALARS))), curves, spent, 0.1, 2**28, MAKER
    )
