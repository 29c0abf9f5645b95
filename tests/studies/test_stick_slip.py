"""Stick and slip: soft springs slip where friction falls with the velocity, stiff ones never."""

import numpy as np
import pytest

from elastomer_friction.studies.stick_slip.figure import SLIPPING, critical_stiffness

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("stick_slip",)


def test_a_soft_spring_slips_and_a_stiff_one_slides(groups):
    data = groups[""]
    swing = (data.drive_swing / data.rms_slope).transpose("velocity", "stiffness")
    critical = critical_stiffness(data)
    falling = np.isfinite(critical.values)
    soft, stiff = data.stiffness.values
    assert falling.any()
    assert (soft < critical.values[falling]).all()
    assert (critical.values[falling] < stiff).all()
    assert (swing.values[falling, 0] > 4.0 * SLIPPING).all()
    assert (swing.values[:, 1] < SLIPPING).all()


def test_a_line_that_slips_goes_faster_than_the_drive(groups):
    data = groups[""]
    share = (data.peak_velocity / data.velocity).transpose("velocity", "stiffness").values
    assert share[1:, 0].min() > 2.0
    assert share[:, 1].max() < 1.3
