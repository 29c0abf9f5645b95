"""Velocity steps: a broad spectrum answers as rate and state does, a Kelvin element does not."""

import numpy as np
import pytest

from elastomer_friction.studies.velocity_steps.figure import simulated_steps

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("velocity_steps",)


@pytest.fixture(scope="module")
def steps(groups):
    """Return the six steps of both materials."""
    return {name: simulated_steps(data) for name, data in groups.items()}


def test_the_direct_effect_of_a_broad_spectrum_is_one_a_up_and_down(steps):
    a = np.array([step.peak[0] / np.log(step.ratio) for step in steps["rubber"]])
    assert a.min() > 0.0
    assert a.max() / a.min() < 1.3


def test_a_broad_spectrum_weakens_with_velocity(steps):
    for step in steps["rubber"]:
        change, error = step.rest
        assert change / np.log(step.ratio) < -3.0 * error / abs(np.log(step.ratio))


def test_a_kelvin_element_strengthens_and_its_direct_effect_is_no_constant(steps):
    slowest, *_, fastest = steps[""]
    for step in steps[""]:
        assert step.rest[0] / np.log(step.ratio) > 3.0 * step.rest[1] / abs(np.log(step.ratio))
    a = [step.peak[0] / np.log(step.ratio) for step in (slowest, fastest)]
    assert a[1] > 3.0 * a[0]


@pytest.mark.parametrize("name", ["", "rubber"])
def test_indentation_falls_as_the_line_speeds_up(steps, name):
    for step in steps[name]:
        near = step.slide.isel(event=step.slide.slid.values > 5e-4)
        sign = np.sign(np.log(step.ratio))
        assert (sign * near.trace_indentation_change < 0.0).all()
