"""Assemble estimates of tasks into one labelled xarray Dataset."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from workflow.plan import Plan, Variant
from workflow.reduce import Estimates
from workflow.result.provenance import provenance
from workflow.result.variables import AXIS_ATTRIBUTES, HEIGHT, SLOPE, attributes, declared
from workflow.study import AXES

Groups = Mapping[str, xr.Dataset]  # "" is the study itself, the others are its comparisons


def build_dataset(
    plan: Plan, variant: Variant, estimates: Estimates, exponents: Estimates
) -> xr.Dataset:
    """Return the dataset of one variant.

    estimates : arrays over variant.tasks. exponents : arrays over the Hurst exponents.
    """
    coords = {axis: np.array(plan.study.grid[axis]) for axis in AXES}
    data = {}
    for name, values in estimates.items():
        variable = declared(name)
        on_grid = values[plan.point_task]
        factor = _factor(variable.scaling, coords)
        if factor is not None:
            on_grid = on_grid * factor.reshape(factor.shape + (1,) * (on_grid.ndim - factor.ndim))
        data[name] = (variable.dims, on_grid)
    data |= {name: (declared(name).dims, values) for name, values in exponents.items()}
    if "mu" in estimates:
        coords["sample"] = np.arange(variant.numerics.curve_samples)
    dataset = xr.Dataset(data, coords, provenance(plan.study, variant.numerics))
    _annotate(dataset, plan.jackknife_groups(variant) - 1)
    return dataset


def _factor(scaling: str, coords: dict[str, np.ndarray]) -> np.ndarray | None:
    """Return what turns a dimensionless value into SI, on the six-dimensional grid."""
    shape = [1] * len(AXES)
    shape[AXES.index("roughness")] = -1
    roughness = coords["roughness"].reshape(shape)
    if scaling == HEIGHT:
        return roughness
    if scaling == SLOPE:
        shape = [1] * len(AXES)
        shape[AXES.index("spacing")] = -1
        return roughness / coords["spacing"].reshape(shape)
    return None


def _annotate(dataset: xr.Dataset, freedom: int) -> None:
    for name in dataset.data_vars:
        dataset[name].attrs = attributes(str(name))
        if f"{name}_error" in dataset:
            dataset[name].attrs["ancillary_variables"] = f"{name}_error"
        if str(name).endswith("_error"):
            dataset[name].attrs["degrees_of_freedom"] = freedom
    for name in dataset.coords:
        units, long_name = AXIS_ATTRIBUTES[str(name)]
        dataset[name].attrs = {"units": units, "long_name": long_name}
