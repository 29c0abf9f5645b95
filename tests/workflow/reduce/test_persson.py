"""The quantity persson: equal to mu_1 in full contact, and the same for both bodies."""

import pytest

import elastomer_friction as ef


def test_both_bodies_have_the_theory_of_the_same_surface():
    """In full contact the theory is exact for the half-space, and independent of the body."""
    scene = {
        "surface": {"length": 1e-3, "rolloff": 5e-4, "hurst": 0.7, "roughness": 1e-6},
        "material": {"shear_modulus": 1e6, "relaxation_time": 1e-4},
        "normal_pressure": 1e7,
        "programme": [{"slide": {"velocity": 0.1, "distance": 1e-4}}],
        "quantities": ["steady", "persson"],
        "realizations": 4,
    }
    scene["surface"]["spacing"] = 1.25e-4
    on_map, on_line = (ef.scene.run(body=body, **scene) for body in ("half-space", "foundation"))
    assert float(on_map.contact_fraction) == 1.0
    assert float(on_map.mu_persson) == pytest.approx(float(on_map.mu_1), rel=0.02)
    assert float(on_line.mu_persson) == float(on_map.mu_persson)
