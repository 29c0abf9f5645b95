"""The CF conventions of netCDF files, as the compliance checker, if installed, reads them."""

import re
from copy import copy
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from unittest import mock

INSTALLED = find_spec("compliance_checker") is not None  # CI fails without it: test_conventions.py
# The first asks every group for a dimension called time; the second subtracts names from names
# where a coordinate has words for values (the law of a fit).
BROKEN = [
    "check_invalid_same_named_dimension_across_groups",
    "check_coordinate_variables_strict_monotonicity",
]
OPTIONAL = 1  # weight of what is no more than advice
# The checker asks for these hundreds of times in one file, which took nine tenths of its time.
ASKED_OFTEN = re.compile(r"get_\w+_variables?")


@cache
def _suite() -> Any:
    from compliance_checker.runner import CheckSuite

    CheckSuite.load_all_available_checkers()
    return CheckSuite()


def _remembering() -> Any:
    """Return a context in which the checker finds out once of a file what it asks for often."""
    from compliance_checker.cf import util

    def once(function: Any) -> Any:
        kept = cache(function)
        return lambda dataset: copy(kept(dataset))

    names = filter(ASKED_OFTEN.fullmatch, dir(util))
    return mock.patch.multiple(util, **{name: once(getattr(util, name)) for name in names})


def complaints(path: Path) -> list[str]:
    """Return what a file has that CF-1.8 does not allow or does not recommend."""
    dataset = _suite().load_dataset(str(path))
    try:
        with _remembering():
            ((results, errors),) = _suite().run_all(dataset, ["cf:1.8"], [], BROKEN).values()
    finally:
        dataset.close()
    assert not errors, errors
    breached = [r for r in results if r.weight > OPTIONAL and r.value[0] < r.value[1]]
    return [message for result in breached for message in result.msgs]
