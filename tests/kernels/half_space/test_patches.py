"""Contact patches on small maps, and the contact area at different resolutions."""

import numba
import numpy as np
import pytest

from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.patches import real_contact, samples_per_patch
from elastomer_friction.kernels.velocity_step.case import Case, Quantities
from tests.kernels.half_space.test_limits import rough


def test_patches_are_connected_by_periodic_sides() -> None:
    p = np.zeros((4, 6))
    p[0, 0] = p[0, 5] = p[3, 0] = 1.0  # one patch across both edges
    p[2, 2] = p[1, 3] = 2.0  # two patches that meet at a corner
    assert samples_per_patch(p) == 5.0 / 3.0
    assert samples_per_patch(np.zeros((4, 4))) == 0.0
    assert samples_per_patch(np.ones((4, 4))) == 16.0


@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="NUMBA_DISABLE_JIT=1: large maps")
@pytest.mark.parametrize("speed", [0.3, 1.0])
def test_the_contact_area_depends_little_on_the_samples(speed: float) -> None:
    requested = Quantities(jump=False, relaxation=False)
    coarse, fine = (
        run_case(rough(8, m, seed=3), Case(0.4, speed, (), (), "exponential"), requested)
        for m in (8, 16)
    )
    assert coarse.contact_fraction == pytest.approx(fine.contact_fraction, rel=0.03)


def test_full_contact_is_not_corrected() -> None:
    assert real_contact(np.ones((8, 8)), 1.0) == 1.0
