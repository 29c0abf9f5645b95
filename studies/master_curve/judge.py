"""How the curves of a result come onto one, and what of it is known beforehand."""

from typing import NamedTuple

import numpy as np
import xarray as xr

from elastomer_friction.workflow.report import not_resolved

from .collapse import ALONG_BOTH, ALONG_SPEED, UNSHIFTED, Collapse, collapse
from .curves import Family, at_forces, at_indentations

WAYS = (UNSHIFTED, ALONG_SPEED, ALONG_BOTH)


class Found(NamedTuple):
    """Curves of one material, pressed in one way, and how they collapse."""

    family: Family
    ways: dict[str, Collapse]  # UNSHIFTED, ALONG_SPEED, ALONG_BOTH


def judge(family: Family) -> Found:
    """Return how the curves of a family collapse onto its reference in all ways."""
    onto = family.curves[family.reference()]
    return Found(family, {way: collapse(family.curves, onto, way) for way in WAYS})


def resolved(dataset: xr.Dataset) -> tuple[xr.Dataset, int]:
    """Return a result without friction where contacts are not resolved, and how many points."""
    coarse = not_resolved(dataset)
    mu = dataset.mu_1.copy(data=np.where(coarse, np.nan, dataset.mu_1.values))
    kept = dataset.assign(mu_1=mu).drop_vars("resolution_status", errors="ignore")
    return kept, int(coarse.sum())


def remaining(dataset: xr.Dataset) -> dict[str, Found]:
    """Return how the curves of a result collapse, at given forces and at given indentations."""
    return {"force": judge(at_forces(dataset)), "indentation": judge(at_indentations(dataset))}


def thermal(found: Found) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return temperatures, and the shift along speed from the highest one, with its error.

    Every pair of curves that differ in temperature alone gives one value.
    """
    shifts = dict(zip(found.family.places, found.ways[ALONG_BOTH].shifts, strict=True))
    warmest = max(place.temperature for place in shifts)
    rows = []
    for place, shift in shifts.items():
        warm = shifts.get(place._replace(temperature=warmest))
        if place.temperature < warmest and warm is not None and warm.points and shift.points:
            error = np.hypot(shift.speed_error, warm.speed_error)
            rows.append((place.temperature, shift.along_speed - warm.along_speed, error))
    table = np.array(rows).reshape(-1, 3)
    return table[:, 0], table[:, 1], table[:, 2]
