"""Estimates of single blocks of a finished run, as a dataset."""

import contextlib
from pathlib import Path

import numpy as np
import xarray as xr

from ..ground import UserError
from ..plan import Variant, make_plan
from ..reduce import Estimates, blocks_of, reduce_blocks, reduction_of
from ..result import check_result, declared, in_si, open_result, units_of
from ..store import DamagedShard, Store, store_folder
from ..study import COMMON_AXES, Study
from ..system import hold

# Parts of a row that serve errors alone:
NOT_OF_A_BLOCK = ("halved_steps", "halved_steps_curve", "slip_changes", "tiles")
NO_MEANS = ("_error", "_bias", "_replicates")  # ends of names


def block_dataset(study: Study, result: Path, group: str = "") -> xr.Dataset:
    """Return the estimates of every block, with the dimension "block" after those of the grid.

    group : name of a comparison. Raises UserError if the result does not belong to the study, or
    if the store lacks a block.
    """
    check_result(study, result, strict=True)
    with contextlib.ExitStack() as stack:
        written = open_result(study, result, stack)
        if group not in written:
            names = ", ".join(name for name in written if name) or "none"
            raise UserError(f"{result}: has no comparison {group!r} (there are: {names})")
        whole = written[group].load()
    plan = make_plan(study)
    variant = next(v for v in plan.variants if v.label == group)
    counts = np.zeros(len(variant.tasks), int)  # blocks of every task
    counts[variant.point_task] = whole.realizations.values // variant.block_size
    estimates = _estimates(variant, counts, plan.widest_row(variant), result)
    units, data = units_of(plan, variant), {}
    for name in [name for name in estimates if name not in whole.coords]:
        dims = (*study.axes, "block", *declared(name).dims[len(COMMON_AXES) :])
        data[name] = in_si(name, estimates[name][variant.point_task], dims, units)
        data[name].attrs = whole[name].attrs if name in whole else {}
    coordinates = {
        name: values for name, values in whole.coords.items() if "law" not in values.dims
    }
    facts = whole.attrs | {"realizations_per_block": variant.block_size}
    return xr.Dataset(data, coordinates, facts)


def _estimates(variant: Variant, counts: np.ndarray, width: int, result: Path) -> Estimates:
    """Return name -> array (tasks, blocks, ...) of single blocks, NaN beyond the last of a task."""
    rows = np.repeat(np.arange(len(variant.tasks)), counts)
    blocks = np.concatenate([np.arange(count) for count in counts])
    tasks = [variant.tasks[row] for row in rows]
    records = [(task.key, int(block)) for task, block in zip(tasks, blocks, strict=True)]
    folder = store_folder(result)
    with hold(folder):
        store = Store(folder)
        lacking = sum(record not in store for record in records)
        if lacking:
            raise UserError(
                f"{folder}: {lacking} blocks of {result.name} are missing; run it again"
            )
        try:
            scalars, curves = store.read(records, width)
        except DamagedShard as error:
            raise UserError(f"{folder}: shard {error} is damaged; run it again") from error
    single = blocks_of(reduction_of(variant), tasks, scalars[:, None], curves[:, None])
    values = {name: part for name, part in single.values.items() if name not in NOT_OF_A_BLOCK}
    estimates = {}
    for name, column in reduce_blocks(single._replace(values=values)).items():
        if column.dtype.kind == "f" and not name.endswith(NO_MEANS):
            shape = (counts.size, counts.max(), *column.shape[1:])
            estimates[name] = np.full(shape, np.nan)
            estimates[name][rows, blocks] = column
    return estimates
