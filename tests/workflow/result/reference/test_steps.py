"""What is said of steady states and jumps holds for one computed line."""

import numpy as np

from tests.workflow.scene.scenes import KELVIN, heights, run

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
