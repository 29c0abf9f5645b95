"""Datasets of synthetic estimates, assembled once."""

import pytest

from tests.support.curves import assembled


@pytest.fixture(scope="package")
def made():
    """Return the plan of the small study, synthetic estimates, and the dataset of both."""
    return assembled()


@pytest.fixture(scope="package")
def dataset(made):
    """Return the dataset of steady states, jumps and relaxations."""
    return made[2]


@pytest.fixture(scope="package")
def with_models():
    """Return a dataset of all quantities."""
    quantities = 'scene.quantities=["steady", "jump", "relaxation", "models"]'
    few = ("grid.hurst=0.3", "grid.spacing=1e-4", "grid.normal_force=0.4")
    return assembled(quantities, *few)[2]
