"""Treatment of points with unresolved contacts in figures and claims."""

from collections import UserDict
from collections.abc import Mapping

import numpy as np
import xarray as xr

from ..reduce import LARGE_BIAS, NARROW_CONTACTS, RESOLVED, RESOLVED_SAMPLES, UNRESOLVED

POINT_STATUS, TRACE_STATUS = "resolution_status", "trace_resolution_status"


def not_resolved(points: xr.Dataset, name: str = POINT_STATUS) -> np.ndarray:
    """Return a mask of points whose contacts are not resolved; all False without a status.

    name : variable with the status of points or of their traces.
    """
    if name not in points:
        return np.zeros(points.realizations.shape if "realizations" in points else (), bool)
    status = points[name].values
    return (status >= 0) & (status < RESOLVED)


def why_hollow(points: xr.Dataset) -> str:
    """Return the reason for hollow markers as text: narrow contacts, a large bias, or both."""
    if "samples_per_contact" not in points:
        return NARROW_CONTACTS
    wide = points.samples_per_contact.values[not_resolved(points)] >= RESOLVED_SAMPLES
    if not wide.any():
        return NARROW_CONTACTS
    return LARGE_BIAS if wide.all() else f"{NARROW_CONTACTS} or {LARGE_BIAS}"


def without_unresolved(dataset: xr.Dataset) -> tuple[xr.Dataset, int]:
    """Return a dataset with its unresolved points masked, and their number.

    Estimates of masked points are NaN and their flags -1, as for failed points.
    """
    if POINT_STATUS not in dataset or not (dataset[POINT_STATUS] == UNRESOLVED).any():
        return dataset, 0
    resolved = dataset[POINT_STATUS] != UNRESOLVED
    masked = {}
    for name, values in dataset.data_vars.items():
        if {*resolved.dims} <= {*values.dims}:
            missing = np.nan if values.dtype.kind == "f" else -1
            masked[name] = values.where(resolved, missing).astype(values.dtype)
    return dataset.assign(masked), int((~resolved).sum())


class Resolved(UserDict[str, xr.Dataset]):
    """Results with unresolved points masked; ``left_out`` counts these in the accessed groups."""

    def __init__(self, results: Mapping[str, xr.Dataset]) -> None:
        super().__init__(results)
        self.left_out: dict[str, int] = {}

    def __getitem__(self, key: str) -> xr.Dataset:
        """Return a dataset with its unresolved points masked, and count them."""
        dataset, self.left_out[key] = without_unresolved(super().__getitem__(key))
        return dataset
