"""Figure 7, reduced to a few points, for the tests of its physics."""

import pytest

from tests.support.studies import Groups, run

FULL_CONTACT = 1000.0  # N


@pytest.fixture(scope="session")
def fig7(tmp_path_factory) -> Groups:
    """Return the groups of figure 7: a rough and a smooth line, two loads and full contact."""
    settings = (
        "study.realizations=32",
        f"grid.normal_force=[0.1, 1.0, {FULL_CONTACT}]",
        "grid.spacing=1e-5",
        "grid.velocity=[1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1]",  # x = 0.03 ... 31
    )
    return run(tmp_path_factory.mktemp("fig7"), "fig7", *settings)
