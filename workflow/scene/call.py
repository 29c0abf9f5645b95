"""Run a scene from Python: one point, computed in the calling process, and its dataset."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from ...kernels import START, Saved
from ..plan import Plan, Variant, cut, make_batches, make_plan, missing_work
from ..reduce import Estimates, blocks_of, completed, reduce_blocks
from ..result import build_dataset
from ..simulate import block_means
from ..study import Study
from .arguments import USUAL, line_and_material, saved_state, study_of, with_mark

PER_TAU = ("relaxation_rate", "relaxation_rate_free", "stretched_rate", "fast_rate", "slow_rate")
IN_TAU = ("time", "fit_window")


def computed(study: Study, resumed: Saved | None = None) -> xr.Dataset:
    """Return the dataset of a study of one point, without dimensions of the grid, times in s.

    resumed : where the programme goes on, on one line; by default it starts as the study says.
    Raises UserError where the plan is refused, ValueError as the kernels do.
    """
    plan = make_plan(study, origin=resumed.origin if resumed else START)
    (variant,) = plan.variants
    dataset = build_dataset(plan, variant, _estimates(plan, variant, resumed), {})
    single = {axis: 0 for axis in study.axes if axis != "hold"}
    return _in_seconds(dataset.isel(single), study)


def _estimates(plan: Plan, variant: Variant, resumed: Saved | None) -> Estimates:
    """Return the estimates of all tasks."""
    tasks, study = variant.tasks, plan.study
    rows = {task.key: row for row, task in enumerate(tasks)}
    width = plan.widest_row(variant)
    scalars, values = None, np.full((len(tasks), study.blocks, width), np.nan)
    whole = cut(plan, missing_work(plan, ()), np.inf)
    for batch in make_batches(plan, whole, 1e9):
        found = block_means(replace(batch, resumed=resumed))
        if scalars is None:
            scalars = np.full((*values.shape[:2], found.scalars.shape[2]), np.nan)
        at = [rows[task.key] for task in batch.tasks]
        blocks = slice(batch.first_block, batch.first_block + batch.blocks)
        scalars[at, blocks] = found.scalars
        values[at, blocks, : found.curves.shape[2]] = found.curves
    assert scalars is not None
    estimates = reduce_blocks(blocks_of(plan, variant, tasks, scalars, values))
    counts = np.full(len(tasks), study.realizations, np.int32)
    estimates.pop("rate_replicates", None)  # for a fit over many points
    return completed(plan, variant, estimates, np.arange(len(tasks)), counts)


def _in_seconds(dataset: xr.Dataset, study: Study) -> xr.Dataset:
    """Return the dataset with times in s and rates in 1/s, and without coordinates that are NaN."""
    tau, found = study.material.tau, {}
    for name in (*dataset.data_vars, *dataset.coords.keys() & {*IN_TAU}):
        variable = dataset[name]
        plain = str(name).removesuffix("_error")
        if plain in IN_TAU or plain in PER_TAU:
            scale, unit = (tau, "s") if plain in IN_TAU else (1.0 / tau, "s-1")
            told = {**variable.attrs, "units": unit}
            told["long_name"] = told["long_name"].replace(", (t - t0)/tau", "")
            told["long_name"] = told["long_name"].replace(", per tau", "").replace(" in tau", "")
            found[name] = (variable * scale).assign_attrs(told)
    known = [name for name, axis in dataset.coords.items() if axis.ndim == 0 and np.isnan(axis)]
    return dataset.assign(found).drop_vars(known)


def run(
    *,
    profile: Any = None,
    length: float | None = None,
    surface: Mapping[str, Any] | None = None,
    material: Mapping[str, Any],
    normal_force: float | None = None,
    prescribed_indentation: float | str | None = None,
    programme: Sequence[Mapping[str, Any]],
    start: str = "steady",
    repeat: int = 1,
    quantities: Sequence[str] = USUAL,
    numerics: Mapping[str, Any] | None = None,
    realizations: int = 1,
    seed: int = 0,
    state: xr.Dataset | None = None,
) -> xr.Dataset:
    """Take a rigid line through a programme of motion over an elastomer; all in SI units.

    profile : heights in m, shape (n,) or (lines, n): one period as it is given, one element per
        sample, one step per sample. length : of that period, m.
    surface : in place of a profile, random lines: the keys of the table [surface], and hurst,
        roughness and spacing as in [grid].
    material : the keys of [material]. numerics : those of [numerics].
    normal_force : N, or prescribed_indentation : m over the mean line, or the name of a file of
        times in s and indentations in m.
    programme : segments, each as in [[scene.programme]]; start, repeat and quantities : as in
        [scene].
    realizations : lines; with several, every mean has its standard error. seed : of random lines.
    state : a dataset of the quantity "state", from which the programme goes on to the bit.

    Returns the variables of a result file (docs/scenes.md) without dimensions of the grid, times
    in s, with its provenance. Raises UserError, one line, for what a study would be refused for.
    """
    arguments = dict(locals())
    study = study_of(arguments)
    resumed = None if state is None else saved_state(state, study)
    return with_mark(computed(study, resumed), line_and_material(study))
