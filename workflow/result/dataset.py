"""Labelled xarray datasets of the estimates of all tasks."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from ...kernels import power_spectrum
from ..plan import Plan, Variant
from ..reduce import (
    STATE_LAWS,
    Estimates,
    GridPoints,
    carried_estimates,
    quantities_of_points,
    standard_error,
    theory_applies,
)
from ..simulate import CONTACT_LENGTH_EDGES
from ..study import COMMON_AXES, HALF_SPACE, axes_of
from .body_text import contact_warning
from .provenance import provenance
from .variables import AUXILIARY, AXIS_ATTRIBUTES, Powers, attributes, declared

Groups = Mapping[str, xr.Dataset]  # "" is the study itself, the others are comparisons
Units = dict[str, xr.DataArray]  # unit of the plan -> value in SI, over the axes it depends on

NO_RATIO = "not measured for a comparison; run it as a study of its own"


def build_dataset(
    plan: Plan, variant: Variant, estimates: Estimates, exponents: Estimates
) -> xr.Dataset:
    """Return the dataset of one variant.

    estimates : arrays over variant.tasks. exponents : arrays over the Hurst exponents. Raises
    KeyError for an undeclared estimate, and TypeError if its type differs from the declaration.
    """
    axes, units = plan.study.axes, units_of(plan, variant)
    data = {}
    for name, values in estimates.items():
        if not name.endswith("_replicates"):
            dims = (*axes, *declared(name).dims[len(COMMON_AXES) :])
            data[name] = in_si(name, values[variant.point_task], dims, units)
    data |= _point_values(plan, variant, estimates, units)
    for name, values in exponents.items():
        data[name] = xr.DataArray(values, dims=declared(name).dims)
    data |= _settings(plan, variant, units) | _spectrum(variant)
    if "time" in data:  # single precision saves space; "time" in tau keeps all digits
        seconds = (data["time"] * units["tau"]).transpose(*data["time"].dims)
        data["time_s"] = seconds.astype(np.float32)
    coords: dict[str, Any] = {axis: np.array(plan.study.grid[axis]) for axis in axes}
    if plan.study.pressures:
        coords["normal_pressure"] = "normal_force", np.array(plan.study.pressures)
    coords |= _coordinates(
        plan, variant, {str(dim) for values in data.values() for dim in values.dims}
    )
    dataset = xr.Dataset(data, coords, _facts(plan, variant) | _effect_facts(plan, variant, data))
    if variant.recording.one_slider and variant.recording.every and "event" in dataset.dims:
        used = np.isfinite(dataset.trace_time).any(dim=[*axes])  # the rest is room for steps
        dataset = dataset.isel(event=used.values)
    freedom = estimates["degrees_of_freedom"]
    _annotate(dataset, int(freedom[freedom >= 0].min()))
    drive = plan.study.scene.drive
    if drive and drive.per_normal_force and "stiffness" in dataset.coords:
        dataset.coords["stiffness"].attrs["units"] = "m-1"
    return dataset.set_coords([name for name in AUXILIARY if name in dataset])


def in_si(name: str, values: np.ndarray, dims: tuple[str, ...], units: Units) -> xr.DataArray:
    """Return an estimate, or its replicates, in SI units. values : at all points of the grid."""
    labelled, powers = xr.DataArray(values, dims=dims), declared(name).scaling.powers
    if not powers:  # a factor would turn a flag into a float
        return labelled
    return (labelled * _factor(powers, units)).transpose(*dims)


def _point_values(
    plan: Plan, variant: Variant, estimates: Estimates, units: Units
) -> dict[str, xr.DataArray]:
    """Return the quantities of reduce/point_quantities.py at all points, with standard errors.

    An undefined value is NaN. The required estimates have replicates NAME_replicates.
    """
    study, dims, data = plan.study, (*plan.study.axes, "replicate"), {}
    request = study.scene.quantities, variant.lines.body
    replicates = {
        name: in_si(name, estimates[f"{name}_replicates"][variant.point_task], dims, units)
        for name in carried_estimates(*request)
    }
    parameters = {axis: xr.DataArray(np.array(study.grid[axis]), dims=axis) for axis in study.axes}
    parameters |= {name: units[name] for name in ("tau", "modulus")}
    parameters["normal_force"] = parameters["normal_force"] * study.force_share(variant.label)
    points = GridPoints(replicates, parameters, partial(_over, plan, variant))
    for name, row in quantities_of_points(*request).items():
        with np.errstate(all="ignore"):
            values = row.function(points).transpose(*dims)
        values = values.where(np.isfinite(values))
        data[name] = values.isel(replicate=0).copy()
        data[f"{name}_error"] = xr.DataArray(standard_error(values.values, -1), dims=dims[:-1])
    return data


def _facts(plan: Plan, variant: Variant) -> dict[str, str | int | float]:
    """Return the global attributes: the provenance, the body and the files that were read."""
    lines, shifts = variant.lines, variant.material.shifts
    facts = provenance(plan.study, variant.numerics) | {"body": lines.body}
    if lines.body == plan.study.surface.body:
        facts["body_reason"] = plan.study.body_reason
    if "steady" in plan.study.scene.quantities:
        is_comparison = variant is not plan.variants[0]
        facts["model_ratio_source"] = NO_RATIO if is_comparison else model_source(plan)
    if plan.study.realizations == 1:
        facts["standard_errors"] = lines.single_error
    share = plan.study.force_share(variant.label)
    if share != 1.0:  # the coordinate normal_force is that of the study
        facts["normal_force_share"] = share
    if lines.profile is not None:
        facts |= {"lines": lines.description, "lines_digest": lines.profile.digest}
    elif lines.power is not None:
        facts |= {"lines": lines.description, "lines_digest": lines.identity}
    files = {
        "branches": variant.material.description,
        "shifts": shifts.description if shifts else "",
        "programme": "; ".join(plan.study.scene.sampled),
    }
    return facts | {name: description for name, description in files.items() if description}


def _effect_facts(
    plan: Plan, variant: Variant, data: Mapping[str, xr.DataArray]
) -> dict[str, str | int | float]:
    """Return heating and shear in words, and the warning of an unresolved surface."""
    effects = plan.study.effects[variant.label]
    shear, heat = effects.shear, effects.heat
    heating: dict[str, str | int | float] = {} if heat is None else {"heat": heat.in_words()}
    if shear is None:
        return heating
    areas = [data[name] for name in ("contact_fraction", "trace_contact_fraction") if name in data]
    largest = max((float(area.max()) for area in areas), default=0.0)
    facts = {"shear": shear.in_words(), "contact_warning": contact_warning(variant.lines, largest)}
    return heating | {name: words for name, words in facts.items() if words}


def model_source(plan: Plan) -> str:
    """Return the source of model_ratio in words."""
    if plan.other_body is not None:
        return "measured on both bodies"
    if theory_applies(plan):
        return f"order of magnitude by Persson's theory; {plan.no_other_body}"
    return f"unknown: {plan.no_other_body}"


def _coordinates(plan: Plan, variant: Variant, dims: set[str]) -> dict[str, object]:
    """Return the coordinates of the dimensions that are not axes of the grid."""
    coordinates: dict[str, object] = {
        "sample": np.arange(variant.numerics.curve_samples),
        "event": np.arange(variant.events),
        "bin": CONTACT_LENGTH_EDGES[:-1],
        "law": list(STATE_LAWS),
    }
    if "x" in dims:  # present for a single realization of a single problem only
        (task,) = variant.tasks
        m = task.steps_per_spacing
        samples, rows = task.problem.elements * m, task.problem.rows(m)
        (spacing,) = plan.study.grid["spacing"]
        step = spacing / m
        coordinates |= {"x": step * np.arange(samples), "y": step * np.arange(rows)}
    return {name: values for name, values in coordinates.items() if name in dims}


def _settings(plan: Plan, variant: Variant, units: Units) -> dict[str, xr.DataArray]:
    """Return tau, G, L and q_max in SI: the scales of the paper's dimensionless quantities."""
    cutoff_wave = _over(plan, variant, "surface", lambda lines: lines.least_wave)
    nyquist_wave = 2.0 * units["spacing"]
    shortest = xr.where(cutoff_wave > nyquist_wave * (1.0 - 1e-9), cutoff_wave, nyquist_wave)
    scales = {
        "tau": units["tau"],
        "shear_modulus": xr.DataArray(variant.material.shear_modulus),
        "length": xr.DataArray(plan.study.surface.length),
        "q_max": (2.0 * np.pi / shortest).transpose("spacing", ...),
    }
    return {name: values for name, values in scales.items() if name not in plan.study.axes}


def _spectrum(variant: Variant) -> dict[str, xr.DataArray]:
    """Return the power spectrum of measured lines, or of random lines with such a spectrum."""
    profile, spectrum = variant.lines.profile, variant.lines.spectrum
    if profile is None or spectrum is None or variant.lines.body == HALF_SPACE:
        return {}
    q, density = power_spectrum(spectrum, profile.length)
    return {"power_spectrum": xr.DataArray(density, {"wave_number": q}, "wave_number")}


def units_of(plan: Plan, variant: Variant) -> Units:
    """Return the units of dimensionless values, in SI."""
    grid = plan.study.grid
    units = {axis: xr.DataArray(np.array(grid[axis]), dims=axis) for axis in COMMON_AXES}
    modulus = _over(plan, variant, "material", lambda solid: solid.contact_modulus)
    units["modulus"] = modulus  # E*, Pa
    units["stiffness"] = modulus * plan.study.surface.length / variant.lines.copies  # E* L, N/m
    units["tau"] = _over(plan, variant, "material", lambda solid: solid.tau)
    return units


def _over(plan: Plan, variant: Variant, part: str, value: Callable[[Any], float]) -> xr.DataArray:
    """Return a value of a part of the study, over the axes that change that part."""
    axes = axes_of(plan.study.grid, part)
    values = [value(getattr(parts, part)) for parts in plan.study.parts(variant.label, axes)]
    return xr.DataArray(
        np.reshape(values, [len(plan.study.grid[axis]) for axis in axes]), dims=axes
    )


def _factor(powers: Powers, units: Units) -> xr.DataArray:
    """Return the factor from a dimensionless value to SI, over the axes that it depends on."""
    factor = xr.DataArray(1.0)
    for unit, power in powers.items():
        values = units[unit]
        factor = factor * values**power if power > 0 else factor / values**-power
    return factor


def _annotate(dataset: xr.Dataset, freedom: int) -> None:
    """Check the type of every variable against its declaration and set its attributes.

    freedom : smallest degrees of freedom of the standard errors.
    """
    for name in dataset.data_vars:
        dtype, expected = dataset[name].dtype, declared(str(name)).dtype
        if dtype != expected:
            raise TypeError(f"{name} is of type {dtype}, but declared as {expected}")
        dataset[name].attrs = attributes(str(name))
        if f"{name}_error" in dataset:
            dataset[name].attrs["ancillary_variables"] = f"{name}_error"
        if str(name).endswith("_error"):
            dataset[name].attrs["degrees_of_freedom"] = freedom
    for name in dataset.coords:
        units, long_name = AXIS_ATTRIBUTES[str(name)]
        dataset[name].attrs = {"units": units, "long_name": long_name}
        if name == "law":  # names, not numbers
            del dataset[name].attrs["units"]
