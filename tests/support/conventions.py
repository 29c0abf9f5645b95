"""The CF conventions of netCDF files, as the compliance checker, if installed, reads them."""

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
ASKED_OFTEN = [
    "get_auxiliary_coordinate_variables",
    "get_axis_variables",
    "get_bounds_variables",
    "get_cell_boundary_variables",
    "get_climatology_variable",
    "get_forecast_metadata_variables",
    "get_geophysical_variables",
    "get_instrument_variables",
    "get_platform_variables",
    "get_time_variable",
    "get_time_variables",
    "get_z_variables",
]


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

    return mock.patch.multiple(util, **{name: once(getattr(util, name)) for name in ASKED_OFTEN})


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
