"""The study of stability at smoke scale: every case within rounding, the map drawn, the table."""

import numpy as np
import pytest

from elastomer_friction.studies.stability import probe
from elastomer_friction.studies.stability.measure import measure, table
from elastomer_friction.studies.stability.probe import COUNTS, RESIDUALS
from elastomer_friction.workflow.study.read import read_study
from tests.support.studies import check_drawing

pytestmark = pytest.mark.exhaustive  # the corners in make test: tests/hard/test_probe.py


@pytest.fixture(scope="module")
def groups():
    """Measure at smoke scale."""
    study = read_study("stability", "smoke")
    groups = measure(study.settings, study.seed, lambda _: None)
    settings = (study.settings["corner_lines"], study.settings["most_elements"])
    assert groups["corners"].sizes["case"] == probe.count_corners(*settings)
    return {name: data.assign_attrs(data.attrs, seed=study.seed) for name, data in groups.items()}


@pytest.mark.parametrize("group", ["", "corners"])
def test_no_case_is_lost_and_residuals_are_rounding_times_the_stiffness(groups, group):
    """K = 1/dt = x m / pi times the larger speed: at most 1.3e8 here, times eps = 2e-16."""
    data = groups[group]
    assert all(np.isfinite(data[kind]).all() for kind in (*RESIDUALS, *COUNTS))
    for kind in ("falling", "subnormal", "not_finite", "contact"):
        assert data[kind].max() == 0.0
    for kind in ("balance", "mean", "energy"):
        assert data[kind].max() < 1e-6
    for kind in ("steady", "march"):
        assert data[kind].max() < 1e-9
    for kind in ("passes", "sweeps"):
        assert 2 <= data[kind].max() <= 15


def test_low_speed_is_exact_to_rounding(groups):
    slow = groups[""].sel(speed_ratio=groups[""].speed_ratio < 1.0)
    assert max(slow[kind].max() for kind in ("balance", "mean", "energy", "steady")) < 1e-12


def test_friction_of_full_and_of_narrow_contacts_does_not_depend_on_the_samples(groups):
    """Narrow contacts are located between the samples."""
    change = groups[""].refinement
    assert change.sel(mean_load=1e4, speed_ratio=1e-4, method="nearest").max() < 1e-6
    assert change.sel(mean_load=1e-6, speed_ratio=1e6, method="nearest").max() < 1e-6


def test_the_figure_is_drawn_and_the_table_names_the_worst_case_of_every_kind(groups):
    check_drawing("stability", groups)
    assert [*table(groups).kind] == [*RESIDUALS, *COUNTS]
