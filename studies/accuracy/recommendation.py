"""Recommended settings for a target accuracy: bias and sampling error at minimum cost."""

import numpy as np
import xarray as xr

MIN_REALIZATIONS = 10  # for a meaningful standard error
REGIMES = ("x < 1", "1 <= x <= 10", "x > 10")
TIME_PART = {"mu_1": 0, "jump": 0, "rate": 1}  # index in TIME_PARTS of the time of a quantity


def recommend(data: xr.Dataset) -> xr.Dataset:
    """Return the cheapest choice per point, quantity and target, and per regime.

    data : errors and times of discretisation.
    """
    choices = cheapest(data)
    return choices.merge(_by_regime(choices))


def cheapest(data: xr.Dataset) -> xr.Dataset:
    """Return the fastest choice: index of the scheme, m, realizations, seconds.

    All are NaN if no m is fine enough.
    """
    data = data.drop_attrs().assign_coords(data.coords)  # attributes do not hold for results
    methods = cost(data).stack(way=("scheme", "steps"))
    best = methods.seconds.fillna(np.inf).argmin("way")
    chosen = methods.isel(way=best).drop_vars(["way", "scheme", "steps"])
    number = data.sizes["steps"]
    steps = best.copy(data=data.steps.values[best.values % number])
    choices = xr.Dataset({"scheme": best // number, "steps": steps}).assign(chosen)
    return choices.where(np.isfinite(choices.seconds)).transpose("point", "sampled", "target")


def cost(data: xr.Dataset) -> xr.Dataset:
    """Return realizations R and seconds of every method that reaches a target, else NaN.

    R is the smallest number with bias^2 + deviation^2 / R <= target^2, where ``deviation`` is that
    of one realization, and the bias includes its standard error.
    """
    data = data.sel(quantity=list(TIME_PART)).rename(quantity="sampled")
    bias = abs(data.bias) + data.bias_error
    room = (data.target**2 - bias**2).where(bias < data.target)
    count = np.maximum(MIN_REALIZATIONS, np.ceil(data.deviation**2 / room))
    per_line = data.seconds.isel(part=xr.DataArray(list(TIME_PART.values()), dims="sampled"))
    return xr.Dataset({"realizations": count, "seconds": count * per_line}).drop_vars("part")


def _by_regime(choices: xr.Dataset) -> xr.Dataset:
    """Return the upper quartile of m, R and seconds over the points of each regime.

    ``reached`` is the share of points for which an m is fine enough.
    """
    regime = np.where(choices.x < 1.0, 0, np.where(choices.x <= 10.0, 1, 2))
    rows = []
    for number in range(len(REGIMES)):
        chosen = choices.isel(point=regime == number)
        part = chosen[["steps", "realizations", "seconds"]]
        # Cost is infinite without a sufficient m; points without relaxation are left out.
        answers = np.isfinite(chosen.seconds).any("target")
        upper = part.fillna(np.inf).where(answers)
        upper = upper.quantile(0.75, "point", method="higher").drop_vars("quantile")
        reached = np.isfinite(chosen.seconds).sum("point") / answers.sum("point")
        rows.append(upper.where(np.isfinite(upper)).assign(reached=reached))
    together = xr.concat(rows, xr.Variable("regime", list(REGIMES)))
    return together.rename({name: f"{name}_of_regime" for name in together.data_vars})


def table_lines(choices: xr.Dataset) -> list[str]:
    """Return the table of m, R and seconds that suffice for three quarters of each regime."""
    lines = [
        "error    sufficient for three quarters of the points (exponential): m, realizations, time"
    ]
    for regime in choices.regime.values:
        lines.append(f"{regime}")
        for target in choices.target.values:
            cells = []
            for name in choices.sampled.values:
                choice = choices.sel(regime=regime, target=target, sampled=name)
                cell = f"(reached at {100.0 * float(choice.reached_of_regime):.0f} %)"
                if np.isfinite(seconds := float(choice.seconds_of_regime)):
                    steps, count = int(choice.steps_of_regime), int(choice.realizations_of_regime)
                    cell = f"{steps}, {count}, {seconds:.2g} s"
                cells.append(f"{name:5s}{cell:30s}")
            lines.append(f"  {100.0 * target:4g} %  " + "".join(cells).rstrip())
    return lines
