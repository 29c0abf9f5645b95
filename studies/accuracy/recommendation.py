"""What to take for a wanted accuracy: bias and sampling error balanced for the least time."""

import numpy as np
import xarray as xr

LEAST_REALIZATIONS = 10  # for a standard error worth its name
REGIMES = ("x < 1", "1 <= x <= 10", "x > 10")
SAMPLED = {"mu_1": 0, "jump": 0, "rate": 1}  # quantity: which part of the time it takes


def recommend(data: xr.Dataset) -> xr.Dataset:
    """Return the cheapest choice per point, quantity and target, and what serves each regime.

    data : errors and times of discretisation.
    """
    found = cheapest(data)
    return found.merge(_by_regime(found))


def cheapest(data: xr.Dataset) -> xr.Dataset:
    """Return the way of least time: index of the scheme, steps m, realizations, seconds.

    All are missing where no m is fine enough.
    """
    data = data.drop_attrs().assign_coords(data.coords)  # what follows has a meaning of its own
    ways = cost(data).stack(way=("scheme", "steps"))
    best = ways.seconds.fillna(np.inf).argmin("way")
    chosen = ways.isel(way=best).drop_vars(["way", "scheme", "steps"])
    number = data.sizes["steps"]
    steps = best.copy(data=data.steps.values[best.values % number])
    found = xr.Dataset({"scheme": best // number, "steps": steps}).assign(chosen)
    return found.where(np.isfinite(found.seconds)).transpose("point", "sampled", "target")


def cost(data: xr.Dataset) -> xr.Dataset:
    """Return realizations R and seconds of every way that reaches a target, missing elsewhere.

    R is the least with bias^2 + deviation^2 / R <= target^2, per realization ``deviation``. The
    bias counts with one standard error of it.
    """
    data = data.sel(quantity=list(SAMPLED)).rename(quantity="sampled")
    bias = abs(data.bias) + data.bias_error
    room = (data.target**2 - bias**2).where(bias < data.target)
    count = np.maximum(LEAST_REALIZATIONS, np.ceil(data.deviation**2 / room))
    each = data.seconds.isel(part=xr.DataArray(list(SAMPLED.values()), dims="sampled"))
    return xr.Dataset({"realizations": count, "seconds": count * each}).drop_vars("part")


def _by_regime(found: xr.Dataset) -> xr.Dataset:
    """Return what serves the points of each regime: largest m and R of three quarters of them.

    ``reached`` is the share of points for which some m is fine enough at all.
    """
    regime = np.where(found.x < 1.0, 0, np.where(found.x <= 10.0, 1, 2))
    rows = []
    for number in range(len(REGIMES)):
        chosen = found.isel(point=regime == number)
        part = chosen[["steps", "realizations", "seconds"]]
        # Points that no m serves count as the dearest; those where nothing relaxes do not count.
        answers = np.isfinite(chosen.seconds).any("target")
        upper = part.fillna(np.inf).where(answers)
        upper = upper.quantile(0.75, "point", method="higher").drop_vars("quantile")
        reached = np.isfinite(chosen.seconds).sum("point") / answers.sum("point")
        rows.append(upper.where(np.isfinite(upper)).assign(reached=reached))
    together = xr.concat(rows, xr.Variable("regime", list(REGIMES)))
    return together.rename({name: f"{name}_of_regime" for name in together.data_vars})


def table_lines(found: xr.Dataset) -> list[str]:
    """Return by regime of x what serves three quarters of its points: m, R and seconds."""
    lines = ["error    take for three quarters of the points (exponential): m, realizations, time"]
    for regime in found.regime.values:
        lines.append(f"{regime}")
        for target in found.target.values:
            cells = []
            for name in found.sampled.values:
                one = found.sel(regime=regime, target=target, sampled=name)
                cell = f"(reached at {100.0 * float(one.reached_of_regime):.0f} %)"
                if np.isfinite(seconds := float(one.seconds_of_regime)):
                    steps, count = int(one.steps_of_regime), int(one.realizations_of_regime)
                    cell = f"{steps}, {count}, {seconds:.2g} s"
                cells.append(f"{name:5s}{cell:30s}")
            lines.append(f"  {100.0 * target:4g} %  " + "".join(cells).rstrip())
    return lines
