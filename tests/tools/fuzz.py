"""Fuzz the reader of studies for FUZZ_SECONDS (600): python -m tests.tools.fuzz, or make fuzz."""

import os
import sys
import time

from hypothesis import seed

os.environ["FUZZ_EXAMPLES"] = "500"  # of each kind in a round
from tests.workflow.study import test_fuzz as fuzz


def main() -> None:
    """Run rounds of new seeds until the time is over; print how many inputs were tried."""
    end = time.monotonic() + float(os.environ.get("FUZZ_SECONDS", "600"))
    count, refused, number = 0, 0, int(os.environ.get("FUZZ_SEED", "0"))
    checked = fuzz.check

    def counting(found):
        nonlocal count, refused
        count += 1
        refused += isinstance(found, str)
        checked(found)

    fuzz.check = counting
    while time.monotonic() < end:
        for test in fuzz.FUZZED:
            if time.monotonic() < end:
                seed(number)(test)()
        number += 1
        print(f"\r{count} inputs, {refused} refused, seed {number}", end="", file=sys.stderr)
    print(f"\n{count} inputs tried, {refused} refused with one line, no other error")


if __name__ == "__main__":
    main()
