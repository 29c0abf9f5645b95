"""What is said of steady states, jumps, traces and snapshots holds for one computed line."""

import numpy as np

from tests.workflow.scene.scenes import KELVIN, heights, run, slide

ROUGHNESS = np.std(heights())


def test_the_indentation_is_negative_at_a_light_load_and_positive_in_full_contact():
    light, heavy = (run(normal_force=force, material=KELVIN) for force in (1e-6, 10.0))
    assert light.indentation < -ROUGHNESS
    assert heavy.indentation > ROUGHNESS
    assert heavy.contact_fraction == 1.0


def test_friction_opposes_sliding_and_the_jump_follows_the_velocity():
    up, down = (
        run(
            {"slide": {"velocity": 0.1, "distance": 1e-4}},
            {"slide": {"velocity": after, "distance": 1e-4}},
            material=KELVIN,
            quantities=["steady", "jump", "trace"],
        )
        for after in (0.12, 0.08)
    )
    assert up.mu_1 > 0.0
    assert down.jump < 0.0 < up.jump


def test_the_rms_slope_is_that_of_the_modes():
    result = run(material=KELVIN)
    modes = np.fft.rfft(heights()) / heights().size
    wave_numbers = 2.0 * np.pi * np.arange(modes.size) / 1e-4
    expected = np.sqrt(2.0 * np.sum(wave_numbers**2 * np.abs(modes) ** 2))
    assert np.isclose(result.rms_slope, expected, rtol=1e-6)


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
