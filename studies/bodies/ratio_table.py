"""Write workflow/plan/ratio_of_bodies.csv from a result of this study.

    python -m elastomer_friction.studies.bodies.ratio_table RESULT.nc

Each point has a row with its coordinates (plan/ratio_of_bodies.py), the ratio, and its error: the
standard error combined with the discretisation bias of both bodies.
"""

import csv
import sys

import numpy as np
import xarray as xr

from elastomer_friction.studies.bodies.figure import PAIRS, ratios
from elastomer_friction.studies.style import computed_study
from elastomer_friction.workflow.plan import KINDS, TABLE, InTable, make_plan, place_of

MIN_SIGNIFICANCE = 3.0  # smallest ratio over its error in the table


def rows_of(tree: xr.DataTree) -> list[tuple]:
    """Return the rows of the table, sorted."""
    plan = make_plan(computed_study(tree.to_dataset()))
    variants = {variant.label: variant for variant in plan.variants}
    rows = []
    for half, line in PAIRS.items():
        variant = variants[half]
        groups = {name: tree[name or "/"].to_dataset() for name in (half, line)}
        of_points = ratios(groups, half)
        biases = [data.mu_1_bias.fillna(0.0).squeeze() for data in groups.values()]
        spread = of_points.ratio_error / of_points.ratio
        off = np.hypot(spread, np.hypot(*biases))
        columns = variant.point_task, of_points.ratio.values, off.values
        for task, ratio, relative in zip(*map(np.ravel, columns), strict=True):
            if MIN_SIGNIFICANCE * relative < 1.0:
                place = place_of(variant.tasks[task].problem)
                rows.append((*place, float(ratio), float(ratio * relative)))
    return sorted(rows)


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
