"""Synthetic results with known laws, on which claims and report are tested."""

import numpy as np
import xarray as xr

from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.result.netcdf import write_datasets
from elastomer_friction.workflow.result.provenance import provenance
from elastomer_friction.workflow.result.variables import AXIS_ATTRIBUTES
from elastomer_friction.workflow.study.axes import COMMON_AXES
from elastomer_friction.workflow.study.read import read_study

RELAXATION_TIME, SLOPE = 1e-3, 0.02


def result(study="fig7", error=0.01, **axes):
    """Return a dataset with axes and provenance; ``add`` adds the estimates."""
    usual = {
        "hurst": [0.3, 0.7],
        "normal_force": [0.1, 1.0],
        "spacing": [2e-6],
        "roughness": [1e-5],
        "velocity": np.geomspace(1e-4, 1e-1, 7),
        "velocity_step": [0.2],
    }
    chosen = usual | axes
    coords = {axis: (axis, np.asarray(chosen[axis], dtype=float)) for axis in COMMON_AXES}
    settings = read_study(study)
    dataset = xr.Dataset(coords=coords, attrs=provenance(settings, settings.variants[""]))
    for axis in COMMON_AXES:
        units, long_name = AXIS_ATTRIBUTES[axis]
        dataset[axis].attrs = {"units": units, "long_name": long_name}
    constants = {
        "shear_modulus": (1e7, "Pa", "relaxed shear modulus G"),
        "tau": (RELAXATION_TIME, "s", "time scale tau"),
        "length": (0.01, "m", "length L of the line, one period"),
    }
    for name, (value, units, long_name) in constants.items():
        dataset[name] = xr.DataArray(value, attrs={"units": units, "long_name": long_name})
    dataset = dataset.set_coords(list(constants))
    x = np.pi * dataset.velocity * RELAXATION_TIME / dataset.spacing
    plain = {"speed_ratio": x, "rms_slope": SLOPE, "contact_fraction": 0.2, "realizations": 10}
    return add(dataset, error, **plain)


def add(dataset, relative_error=0.01, **estimates):
    """Add estimates and their standard errors on the whole grid; return the dataset."""
    shape = tuple(dataset.sizes[axis] for axis in COMMON_AXES)
    for name, values in estimates.items():
        full = xr.DataArray(np.zeros(shape), dims=COMMON_AXES) + values
        dataset[name] = full.transpose(*COMMON_AXES)
        dataset[f"{name}_error"] = np.abs(dataset[name]) * relative_error
    return dataset


def with_rates(dataset, rate, **how):
    """Return the dataset with fitted rates."""
    status = xr.zeros_like(dataset.speed_ratio) + FITTED
    dataset = add(dataset, **how, relaxation_rate=rate, fit_quality=0.99)
    return dataset.assign(fit_status=status.astype(np.int8))


def with_alpha(dataset, alpha, error=0.01):
    """Return the dataset with exponents of eq. 13, one per Hurst exponent."""
    alpha = alpha * xr.ones_like(dataset.hurst)
    fitted = {"alpha": alpha, "alpha_error": 0.0 * alpha + error, "alpha_free": alpha}
    fitted |= {"alpha_free_error": fitted["alpha_error"], "alpha_points": 0 * alpha + 10}
    fitted["alpha_prefactor"] = 0 * alpha + 1.0
    return dataset.assign(fitted)


def write_figure_8(folder):
    """Write a result of figure 8 with alpha = 1 - H + 0.05, and the same as "paper_step"."""
    velocity = [1e-3] + [0.1 * k for k in range(1, 8)]
    dataset = result("fig8", hurst=[0.0, 0.5, 1.0], velocity=velocity)
    dataset = with_alpha(dataset, 1.05 - dataset.hurst)
    write_datasets(folder / "fig8.nc", {"": dataset, "paper_step": dataset})
