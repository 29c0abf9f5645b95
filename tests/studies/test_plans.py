"""Every study can be planned at every scale and fits into a worker."""

import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

import studies
from tests.support.small import cut_batches
from tests.support.sweeps import mostly_exhaustive, sweep
from workflow.plan.plan import make_plan
from workflow.study.measured import Measured
from workflow.study.read import read_study

MEASURED = ("accuracy", "scaling", "stability")
FOLDERS = sorted(path.parent for path in Path(studies.__file__).parent.glob("*/study.toml"))
SCALES = [
    (folder.name, scale)
    for folder in FOLDERS
    for scale in [None, *tomllib.loads((folder / "study.toml").read_text()).get("scales", {})]
]
GRIDS = [case for case in SCALES if case[0] not in MEASURED]
SLOW = [("scaling", None), ("scaling", "paper")]  # they plan figure 7 of the paper
QUICK = [case for case in SCALES if case not in GRIDS + SLOW]


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_study_has_its_scales_and_a_figure(folder):
    scales = [scale for name, scale in SCALES if name == folder.name]
    assert {"smoke", "paper"} <= set(scales)
    assert (folder / "figure.py").is_file()


@sweep("every", False, True)
@pytest.mark.parametrize(("name", "scale"), GRIDS)
def test_study_is_planned(name, scale, every):
    study = read_study(name, scale)
    if not every:  # the ends of all axes
        ends = {axis: tuple(dict.fromkeys((v[0], v[-1]))) for axis, v in study.grid.items()}
        study = replace(study, grid=ends)
    plan = make_plan(study)
    assert 1 <= plan.problems <= plan.points
    assert plan.predicted_worker_bytes() < 2**30


@mostly_exhaustive(("name", "scale"), QUICK, SLOW)
def test_measured_study_is_outlined(name, scale):
    study = read_study(name, scale)
    lines, seconds = study.script.outline(study.settings)
    assert lines
    assert 0.0 < seconds < 86400.0


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_smoke_scale_is_small(folder):
    study = read_study(folder.name, "smoke")
    if isinstance(study, Measured):
        seconds = study.script.outline(study.settings)[1]
    else:
        seconds = sum(batch.seconds for batch in cut_batches(make_plan(study), set()))
    assert seconds < 30.0  # predicted


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_study_says_what_it_is(folder):
    study = read_study(folder.name)
    assert study.name == folder.name
    assert study.title != study.name
