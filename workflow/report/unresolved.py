"""What figures and claims do with points whose contacts are not resolved."""

from collections import UserDict
from collections.abc import Mapping

import numpy as np
import xarray as xr

from ..reduce import ENOUGH, NARROW, OFF, RESOLVED, UNRESOLVED

STATUS, TRACE_STATUS = "resolution_status", "trace_resolution_status"


def not_resolved(points: xr.Dataset, name: str = STATUS) -> np.ndarray:
    """Return where contacts are coarse or unresolved; nowhere where the result does not say.

    name : of the status, that of points or of their traces.
    """
    if name not in points:
        return np.zeros(points.realizations.shape if "realizations" in points else (), bool)
    status = points[name].values
    return (status >= 0) & (status < RESOLVED)


def why_hollow(points: xr.Dataset) -> str:
    """Return what the points that are not resolved have, in words: narrow contacts, or an error."""
    hollow = not_resolved(points)
    known = "samples_per_contact" in points
    wide = hollow & (points.samples_per_contact.values >= ENOUGH) if known else np.zeros(1, bool)
    count = np.count_nonzero(wide)
    if not count:
        return NARROW
    return f"{NARROW} or {OFF}" if np.count_nonzero(hollow) > count else OFF


def without_unresolved(dataset: xr.Dataset) -> tuple[xr.Dataset, int]:
    """Return a dataset in which unresolved points are as if they had failed, and their number.

    Their estimates are NaN and their flags -1.
    """
    if STATUS not in dataset:
        return dataset, 0
    known = dataset[STATUS] != UNRESOLVED
    count = int((~known).sum())
    if not count:
        return dataset, 0
    grid = set(known.dims)
    kept = {
        name: values.where(known, np.nan if values.dtype.kind == "f" else -1).astype(values.dtype)
        for name, values in dataset.data_vars.items()
        if grid <= set(values.dims)
    }
    return dataset.assign(kept), count


class Resolved(UserDict[str, xr.Dataset]):
    """Results without their unresolved points; knows how many those looked at had."""

    def __init__(self, results: Mapping[str, xr.Dataset]) -> None:
        super().__init__(results)
        self.left_out: dict[str, int] = {}

    def __getitem__(self, key: str) -> xr.Dataset:
        """Return a dataset as claims may use it."""
        dataset, self.left_out[key] = without_unresolved(super().__getitem__(key))
        return dataset
