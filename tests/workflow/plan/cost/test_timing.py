"""The measurement of a machine: every part of the work of a worker, in positive times."""

import pytest

from elastomer_friction.workflow.plan.cost.timing import PROBES, batch, factors, typical
from elastomer_friction.workflow.plan.cost.work import PARTS


@pytest.mark.exhaustive  # computes all probes
def test_every_part_is_timed():
    found = factors(rounds=2)
    assert set(found) == set(PARTS)
    for factor, worst in found.values():
        assert factor > 0.0
        assert worst >= 1.0


def test_probes_have_work_in_every_part():
    for probe in PROBES:
        assert (typical(batch(*probe)) > 0.0).all()
