"""While nothing is collected Python looks for no garbage; after it all is as it was."""

import gc
import subprocess
import sys
from pathlib import Path

import pytest

from elastomer_friction.kernels.compile.garbage import nothing_collected


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


ENDING = """
import gc
{first}
gc.disable()

class Garbage:
    def __del__(self):
        print("found")

garbage = Garbage()
garbage.own = garbage
del garbage
"""


@pytest.mark.parametrize(
    ("first", "found"), [("", "found\n"), ("import elastomer_friction.kernels.compile.garbage", "")]
)
def test_at_its_end_a_process_looks_for_no_garbage(first, found):
    command = [sys.executable, "-c", ENDING.format(first=first)]
    root = Path(__file__).resolve().parents[2]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
    assert done.stdout == found
