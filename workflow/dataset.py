"""Assemble estimates of tasks into one labelled xarray Dataset and write it."""

import contextlib
import os
from pathlib import Path

import dask
import numpy as np
import xarray as xr

from workflow.errors import UserError
from workflow.fits import FITTED, fit_power_law
from workflow.plan import Plan, Variant
from workflow.provenance import provenance
from workflow.reduction import Estimates
from workflow.resolution import speed_ratio
from workflow.statistics import standard_error
from workflow.study import AXES
from workflow.variables import AXIS_ATTRIBUTES, HEIGHT, SLOPE, attributes, declared


def build_dataset(plan: Plan, variant: Variant, estimates: Estimates) -> xr.Dataset:
    """Return the dataset of one variant; ``estimates`` are arrays over variant.tasks."""
    replicates = estimates.pop("rate_replicates", None)
    estimates["speed_ratio"] = np.array([speed_ratio(t.problem.speed) for t in variant.tasks])
    steps = [task.steps_per_spacing for task in variant.tasks]
    estimates["steps_per_spacing"] = np.array(steps, np.int32)
    coords = {axis: np.array(plan.study.grid[axis]) for axis in AXES}
    data = {}
    for name, values in estimates.items():
        variable = declared(name)
        on_grid = values[plan.point_task]
        factor = _factor(variable.scaling, coords)
        if factor is not None:
            on_grid = on_grid * factor.reshape(factor.shape + (1,) * (on_grid.ndim - factor.ndim))
        data[name] = (variable.dims, on_grid)
    if replicates is not None:
        data |= _power_laws(plan, variant, estimates, replicates)
        coords["sample"] = np.arange(variant.numerics.samples)
    dataset = xr.Dataset(data, coords, provenance(plan.study, variant.numerics))
    _annotate(dataset, plan.groups(variant) - 1)
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


def _power_laws(
    plan: Plan, variant: Variant, estimates: Estimates, replicates: np.ndarray
) -> dict[str, tuple]:
    """Return the fits of eq. 13, one per Hurst exponent, over distinct problems with x > 1."""
    hurst = np.array([task.problem.hurst for task in variant.tasks])
    x = estimates["speed_ratio"]
    usable = (estimates["fit_status"] == FITTED) & (x > 1.0)
    fits = []
    for value in plan.study.grid["hurst"]:
        chosen = usable & (hurst == value)
        fits.append(fit_power_law(x[chosen], replicates[chosen]))
    found: dict[str, np.ndarray] = {}
    for name, rows in (
        ("alpha", [fit.alpha for fit in fits]),
        ("alpha_free", [fit.alpha_free for fit in fits]),
        ("alpha_prefactor", [fit.prefactor for fit in fits]),
    ):
        values = np.array(rows)
        found[name] = values[:, 0]
        found[f"{name}_error"] = standard_error(values, 1)
    found["alpha_scatter"] = np.array([fit.scatter for fit in fits])
    found["alpha_points"] = np.array([fit.points for fit in fits], dtype=np.int32)
    return {name: (declared(name).dims, values) for name, values in found.items()}


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


def write_datasets(path: Path, datasets: dict[str, xr.Dataset]) -> None:
    """Write the study at the root of a netCDF file and each comparison as a group of it.

    The file is written aside and renamed: readers keep the old one until then.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with dask.config.set(scheduler="synchronous"):  # or xarray asks a scheduler for its lock
            for label, dataset in datasets.items():
                mode = "a" if label else "w"
                dataset.to_netcdf(aside, mode, group=label or None, encoding=_encoding(dataset))
        with aside.open("rb+") as file:
            os.fsync(file.fileno())
        aside.replace(path)
    except (OSError, RuntimeError) as error:  # HDF5 reports a full disk as RuntimeError
        with contextlib.suppress(OSError):
            aside.unlink()
        raise UserError(f"{path}: cannot be written: {error}") from error


def _encoding(dataset: xr.Dataset) -> dict:
    """Return how variables are stored: with a checksum each, curves compressed."""
    curve = {"zlib": True, "complevel": 1}
    return {
        name: {"fletcher32": variable.ndim > 0, **(curve if variable.ndim > 6 else {})}
        for name, variable in dataset.variables.items()
    }
