"""Every study can be planned at every scale and fits into a worker."""

import tomllib
from dataclasses import replace

import pytest

from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.study.measured import Measured
from elastomer_friction.workflow.study.read import known_studies, read_study
from tests.support.small import cut_batches
from tests.support.sweeps import sweep

SCALES = {
    name: [None, *tomllib.loads(path.read_text()).get("scales", {})]
    for name, path in sorted(known_studies().items())
}
CASES = [(name, scale) for name, scales in SCALES.items() for scale in scales]
MEASURED = ("accuracy", "area", "sphere", "stability")
GRIDS = [case for case in CASES if case[0] not in MEASURED]


@pytest.mark.parametrize("name", SCALES)
def test_study_has_its_scales_a_title_and_a_figure(name):
    assert {"smoke", "paper"} <= set(SCALES[name])
    study = read_study(name)
    assert study.name == name
    assert study.title != name
    assert (study.folder / "figure.py").is_file()


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


@pytest.mark.parametrize(("name", "scale"), [case for case in CASES if case not in GRIDS])
def test_measured_study_is_outlined(name, scale):
    study = read_study(name, scale)
    lines, seconds = study.script.outline(study.settings)
    assert lines
    assert 0.0 < seconds < 86400.0


# Coarser at smoke scale, at velocities that keep x: values of an axis of one length differ.
COARSER = {
    "fig7_half_space",
    "oscillation",
    "rate_state",
    "refinement",
    "slide_hold_slide",
    "stick_slip",
    "velocity_steps",
}


@pytest.mark.parametrize("name", sorted(set(SCALES) - {*MEASURED} - COARSER))
def test_values_at_smoke_scale_are_some_of_the_usual_ones(name):
    """What is looked up by its value in the one result is found in the other."""
    usual, small = read_study(name), read_study(name, "smoke")
    for axis in usual.axes:
        assert set(small.grid[axis]) <= set(usual.grid[axis]), axis


@pytest.mark.parametrize("name", SCALES)
def test_smoke_scale_is_small(name):
    study = read_study(name, "smoke")
    if isinstance(study, Measured):
        seconds = study.script.outline(study.settings)[1]
    else:
        seconds = sum(batch.seconds for batch in cut_batches(make_plan(study), set()))
    assert seconds < 30.0  # predicted
