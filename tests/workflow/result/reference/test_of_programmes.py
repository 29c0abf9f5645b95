"""What is said of traces and snapshots holds for one computed line."""

import numpy as np

from tests.workflow.scene.scenes import KELVIN, run, slide


def test_friction_is_negative_in_sliding_back():
    trace = run(slide(0.1), slide(-0.1, 64), material=KELVIN)
    ends = trace.trace_mu.dropna("event")
    assert ends[-1] < 0.0 < ends[0]
    assert np.all(np.diff(trace.trace_distance[-5:]) < 0.0)


def test_a_snapshot_shows_the_line_below_the_surface_where_it_touches():
    shapes = run(material=KELVIN, quantities=["trace", "snapshots"])
    line, elastomer = shapes.snapshot_height[-1], shapes.snapshot_displacement[-1]
    assert np.all(elastomer <= line + 1e-15)
    touching = np.isclose(line, elastomer, rtol=0.0, atol=1e-15)
    assert touching.any()
    assert np.all(elastomer[touching] < 0.0)


def test_forces_are_those_of_their_ratio():
    trace = run(material=KELVIN)
    ratio = trace.trace_friction_force / trace.trace_normal_force
    assert np.allclose(ratio, trace.trace_mu, rtol=1e-9)
