"""Every study can be planned at every scale and fits into a worker."""

import tomllib
from pathlib import Path

import pytest

import studies
from tests.workflow.small import cut_batches
from workflow.plan.plan import make_plan
from workflow.study.measured import Measured
from workflow.study.read import read_study

FOLDERS = sorted(path.parent for path in Path(studies.__file__).parent.glob("*/study.toml"))
SCALES = [
    (folder.name, scale)
    for folder in FOLDERS
    for scale in [None, *tomllib.loads((folder / "study.toml").read_text()).get("scales", {})]
]


def test_there_are_studies():
    assert "fig7" in [folder.name for folder in FOLDERS]


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_study_has_its_scales_and_a_figure(folder):
    scales = [scale for name, scale in SCALES if name == folder.name]
    assert {"smoke", "paper"} <= set(scales)
    assert (folder / "figure.py").is_file()


@pytest.mark.parametrize(("name", "scale"), SCALES)
def test_study_is_planned(name, scale):
    study = read_study(name, scale)
    if isinstance(study, Measured):
        lines, seconds = study.script.outline(study.settings)
        assert lines
        assert 0.0 < seconds < 86400.0
        return
    plan = make_plan(study)
    assert 1 <= plan.problems <= plan.points
    assert plan.predicted_worker_bytes() < 2**30


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
