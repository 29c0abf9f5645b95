"""The garbage collector is paused for a block, and at the end of a process."""

import gc

import pytest

from elastomer_friction.workflow.ground import garbage_collection_paused


def fail():
    """Fail while nothing is collected."""
    with garbage_collection_paused():
        assert not gc.isenabled()
        raise ZeroDivisionError


@pytest.mark.parametrize("enabled", [True, False])
def test_the_collector_is_as_it_was_after_an_error_too(enabled):
    usual = gc.isenabled()
    (gc.enable if enabled else gc.disable)()
    try:
        with pytest.raises(ZeroDivisionError):
            fail()
        assert gc.isenabled() == enabled
    finally:
        (gc.enable if usual else gc.disable)()
