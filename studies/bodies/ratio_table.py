"""Write workflow/plan/ratio_of_bodies.csv from a result of this study.

    python -m elastomer_friction.studies.bodies.ratio_table RESULT.nc

A row for each point: what it is (plan/ratio_of_bodies.py), the ratio, and its standard error with
the bias of the discretisation of both bodies.
"""

import csv
import sys

import numpy as np
import xarray as xr

from elastomer_friction.studies.bodies.figure import PAIRS
from elastomer_friction.studies.style import computed_study
from elastomer_friction.workflow.plan import KINDS, TABLE, InTable, make_plan, place_of

LEAST_RATIO = 3.0  # of a ratio to its error, below which it says nothing


def rows_of(tree: xr.DataTree) -> list[tuple]:
    """Return the rows of the table, sorted."""
    plan = make_plan(computed_study(tree.to_dataset()))
    variants = {variant.label: variant for variant in plan.variants}
    found = []
    for half, line in PAIRS.items():
        variant = variants[half]
        whole, other = tree[half or "/"].to_dataset(), tree[line].to_dataset()
        values = {name: [each[name].values for each in (whole, other)] for name in NEEDED}
        for index in np.ndindex(variant.point_task.shape):
            place = place_of(variant.tasks[variant.point_task[index]].problem)
            mu, error, bias = ([each[index] for each in values[name]] for name in NEEDED)
            ratio = mu[1] / mu[0]
            off = [
                np.hypot(e / m, np.nan_to_num(b)) for m, e, b in zip(mu, error, bias, strict=True)
            ]
            own = abs(ratio) * float(np.hypot(*off))
            if ratio > LEAST_RATIO * own:
                found.append((*place, ratio, own))
    return sorted(found)


NEEDED = ("mu_1", "mu_1_error", "mu_1_bias")


def _main() -> None:
    """Write the table."""
    with xr.open_datatree(sys.argv[1]) as tree, TABLE.open("w", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow((*InTable._fields, "ratio", "error"))
        for kind, *numbers in rows_of(tree):
            assert kind in KINDS
            writer.writerow((kind, *(f"{number:.6g}" for number in numbers)))


if __name__ == "__main__":
    _main()
