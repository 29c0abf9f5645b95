"""Check of the CF conventions of netCDF files by the compliance checker, if it is installed."""

import re
from copy import copy
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from unittest import mock

INSTALLED = find_spec("compliance_checker") is not None  # CI fails without it: test_conventions.py
# Checks with bugs: the first requires a dimension called time in every group; the second subtracts
# strings if a coordinate has strings as values (the law of a fit).
BROKEN = [
    "check_invalid_same_named_dimension_across_groups",
    "check_coordinate_variables_strict_monotonicity",
]
OPTIONAL = 1  # weight of checks that are only advice
# The checker calls these functions hundreds of times per file, which took 90 % of its time.
ASKED_OFTEN = re.compile(r"get_\w+_variables?")


@cache
def _suite() -> Any:
    from compliance_checker.runner import CheckSuite

    CheckSuite.load_all_available_checkers()
    return CheckSuite()


def _cached_lookups() -> Any:
    """Return a context in which the functions ASKED_OFTEN are cached by dataset."""
    from compliance_checker.cf import util

    def once(function: Any) -> Any:
        cached = cache(function)
        return lambda dataset: copy(cached(dataset))

    names = filter(ASKED_OFTEN.fullmatch, dir(util))
    return mock.patch.multiple(util, **{name: once(getattr(util, name)) for name in names})


def complaints(path: Path) -> list[str]:
    """Return the violations of CF-1.8 requirements and recommendations in a file."""
    dataset = _suite().load_dataset(str(path))
    try:
        with _cached_lookups():
            ((results, errors),) = _suite().run_all(dataset, ["cf:1.8"], [], BROKEN).values()
    finally:
        dataset.close()
    assert not errors, errors
    breached = [r for r in results if r.weight > OPTIONAL and r.value[0] < r.value[1]]
    return [message for result in breached for message in result.msgs]
