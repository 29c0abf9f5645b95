"""Fuzz the reader of studies and the calls of a scene for FUZZ_SECONDS (600): make fuzz.

FUZZ_SEED is the first seed (0); with FUZZ_ONLY=calls, scenes alone are called. What takes longer
than two minutes ends the process with the place where it hangs.
"""

import faulthandler
import os
import sys
import time

from hypothesis import seed

os.environ["FUZZ_EXAMPLES"] = "500"  # of each kind in a round
from tests.workflow.scene import test_random_calls as calls
from tests.workflow.study import test_fuzz as fuzz

LONGEST = 120.0  # seconds of one input


def main() -> None:
    """Run rounds of new seeds until the time is over; print how many inputs were tried."""
    end = time.monotonic() + float(os.environ.get("FUZZ_SECONDS", "600"))
    count, refused, number = 0, 0, int(os.environ.get("FUZZ_SEED", "0"))
    of_calls = (calls.test_a_call_with_random_arguments_is_computed_or_refused,)
    tests = of_calls if os.environ.get("FUZZ_ONLY") == "calls" else (*fuzz.FUZZED, *of_calls)

    def counted(checked):
        def counting(found):
            nonlocal count, refused
            count += 1
            refused += isinstance(found, str)
            faulthandler.dump_traceback_later(LONGEST, exit=True)
            checked(found)

        return counting

    fuzz.check, calls.check = counted(fuzz.check), counted(calls.check)
    while time.monotonic() < end:
        for test in tests:
            if time.monotonic() < end:
                seed(number)(test)()
        number += 1
        print(f"\r{count} inputs, {refused} refused, seed {number}", end="", file=sys.stderr)
    faulthandler.cancel_dump_traceback_later()
    print(f"\n{count} inputs tried, {refused} refused with one line, no other error")


if __name__ == "__main__":
    main()
