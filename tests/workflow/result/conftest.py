"""Datasets of made-up estimates, put together once."""

import pytest

from tests.support.curves import assembled


@pytest.fixture(scope="package")
def made():
    """Return the plan of the small study, made-up estimates, and the dataset of both."""
    return assembled()


@pytest.fixture(scope="package")
def dataset(made):
    """Return the dataset of steady states, jumps and relaxations."""
    return made[2]


@pytest.fixture(scope="package")
def with_models():
    """Return a dataset of everything that can be asked for."""
    asked = 'scene.quantities=["steady", "jump", "relaxation", "models"]'
    few = ("grid.hurst=0.3", "grid.spacing=1e-4", "grid.normal_force=0.4")
    return assembled(asked, *few)[2]
