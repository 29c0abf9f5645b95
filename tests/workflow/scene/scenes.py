"""A small scene that the tests of this room share."""

import numpy as np

from elastomer_friction.workflow import scene

N, LENGTH = 128, 1e-4
MATERIAL = {"shear_modulus": 1e6, "branches": [[5e6, 1e-3], [1e7, 1e-4]]}
KELVIN = {"shear_modulus": 1e6, "relaxation_time": 1e-3}
PULL = {"pull": {"velocity": 0.1, "distance": 64 * LENGTH / N}}


def heights(count=N):
    """Return one period of a wavy line, in m."""
    x = 2.0 * np.pi * np.arange(count) / count
    return 1e-6 * (np.cos(x) + 0.3 * np.cos(5.0 * x + 1.0) + 0.1 * np.cos(17.0 * x))


def slide(velocity=0.1, samples=32):
    """Return a segment that slides by whole samples."""
    return {"slide": {"velocity": velocity, "distance": samples * LENGTH / N}}


def run(*programme, **changed):
    """Return the dataset of the scene with other arguments."""
    given = {
        "profile": heights(),
        "length": LENGTH,
        "normal_force": 1.0,
        "material": MATERIAL,
        "programme": programme or [slide()],
    }
    return scene.run(**(given | changed))


def run_on_half_space(programme, **changed):
    """Return the dataset of a scene on a small half-space."""
    given = {"programme": programme, "numerics": {"steps_per_spacing": 2}, "seed": 5}
    return scene.run(**(given | changed))
