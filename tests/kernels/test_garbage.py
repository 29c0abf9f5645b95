"""While nothing is collected Python looks for no garbage; after it all is as it was."""

import gc

import pytest

from kernels.garbage import nothing_collected


def fail():
    """Fail while nothing is collected."""
    with nothing_collected():
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
