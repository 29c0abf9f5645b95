"""Assemble estimates of tasks into one labelled xarray Dataset."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from workflow.plan import Plan, Variant
from workflow.reduce import Estimates
from workflow.result.provenance import provenance
from workflow.result.variables import AXIS_ATTRIBUTES, Powers, attributes, declared
from workflow.study import AXES

Groups = Mapping[str, xr.Dataset]  # "" is the study itself, the others are its comparisons


def build_dataset(
    plan: Plan, variant: Variant, estimates: Estimates, exponents: Estimates
) -> xr.Dataset:
    """Return the dataset of one variant.

    estimates : arrays over variant.tasks. exponents : arrays over the Hurst exponents. Raises
    KeyError for an estimate that is not declared, TypeError for one that is of another type.
    """
    coords = {axis: np.array(plan.study.grid[axis]) for axis in AXES}
    data = {}
    for name, values in estimates.items():
        variable = declared(name)
        data[name] = xr.DataArray(values[plan.point_task], dims=variable.dims)
        if variable.scaling:  # or a flag would become a float
            data[name] = data[name] * _factor(variable.scaling, coords)
    for name, values in exponents.items():
        data[name] = xr.DataArray(values, dims=declared(name).dims)
    if "mu" in estimates:
        coords["sample"] = np.arange(variant.numerics.curve_samples)
    dataset = xr.Dataset(data, coords, provenance(plan.study, variant.numerics))
    _annotate(dataset, plan.jackknife_groups(variant) - 1)
    return dataset


def _factor(scaling: Powers, coords: dict[str, np.ndarray]) -> xr.DataArray:
    """Return what turns a dimensionless value into SI, over the axes that it depends on."""
    factor = xr.DataArray(1.0)
    for axis, power in scaling.items():
        values = xr.DataArray(coords[axis], dims=axis)
        factor = factor * values**power if power > 0 else factor / values**-power
    return factor


def _annotate(dataset: xr.Dataset, freedom: int) -> None:
    """Check that every variable is what it is declared to be; say so in its attributes."""
    for name in dataset.data_vars:
        found, said = dataset[name].dtype, declared(str(name)).dtype
        if found != said:
            raise TypeError(f"{name} is of type {found}, but declared as {said}")
        dataset[name].attrs = attributes(str(name))
        if f"{name}_error" in dataset:
            dataset[name].attrs["ancillary_variables"] = f"{name}_error"
        if str(name).endswith("_error"):
            dataset[name].attrs["degrees_of_freedom"] = freedom
    for name in dataset.coords:
        units, long_name = AXIS_ATTRIBUTES[str(name)]
        dataset[name].attrs = {"units": units, "long_name": long_name}
