"""A few random kills of everything that can be killed; ``make chaos`` runs many."""

import pytest

from tests.tools.chaos import run_chaos

pytestmark = pytest.mark.cluster


def test_kills_change_no_bit_and_lose_no_finished_work(tmp_path):
    report = run_chaos(tmp_path, kills=8, seed=7, core_seconds=40.0)
    assert report[0].startswith("8 kills")
