"""What to take for a wanted accuracy: bias and sampling error balanced for the least time."""

from typing import NamedTuple

import numpy as np
import xarray as xr

LEAST_REALIZATIONS = 10  # for a standard error worth its name


class Choice(NamedTuple):
    """The cheapest way to a wanted error."""

    steps: int  # m; 0 where no m is fine enough
    realizations: int
    seconds: float


def choose(
    steps: list[int], bias: np.ndarray, deviation: float, seconds: np.ndarray, target: float
) -> Choice:
    """Return m and the number of realizations R with bias^2 + deviation^2 / R <= target^2.

    bias, seconds : per m, relative and per realization. deviation : relative, of one realization.
    """
    best = Choice(0, 0, np.nan)
    for m, b, cost in zip(steps, bias, seconds, strict=True):
        if not (np.isfinite(deviation) and b < target):
            continue
        count = max(LEAST_REALIZATIONS, int(np.ceil(deviation**2 / (target**2 - b**2))))
        if best.steps == 0 or count * cost < best.seconds:
            best = Choice(m, count, count * cost)
    return best


REGIMES = ("x < 1", "1 <= x <= 10", "x > 10")
SAMPLED = ("mu_1", "jump", "rate")


def recommend(data: xr.Dataset) -> xr.Dataset:
    """Return the cheapest choice per point, quantity and target, and their medians by regime.

    data : errors and times of discretisation. The bias counts with one standard error of it.
    """
    targets, schemes = data.target.values, list(data.scheme.values)
    shape = (data.sizes["point"], len(SAMPLED), targets.size)
    names = {"scheme": "index of the scheme", "steps": "m", "realizations": "R", "seconds": "cost"}
    found = {name: np.full(shape, np.nan) for name in names}
    for k in range(shape[0]):
        for q, name in enumerate(SAMPLED):
            for t, target in enumerate(targets):
                picked = _cheapest(data.isel(point=k).sel(quantity=name), name, float(target))
                if picked[1].steps:
                    row = (schemes.index(picked[0]), *picked[1])
                    for key, value in zip(names, row, strict=True):
                        found[key][k, q, t] = value
    dims = ("point", "sampled", "target")
    coords = {name: data[name] for name in ("point", "hurst", "load", "x", "target")}
    dataset = xr.Dataset(
        {name: (dims, values) for name, values in found.items()},
        coords | {"sampled": list(SAMPLED)},
    )
    return dataset.merge(_by_regime(dataset))


def _cheapest(point: xr.Dataset, quantity: str, target: float) -> tuple[str, Choice]:
    """Return the scheme and the choice with the least time."""
    bound = abs(point.bias) + point.bias_error
    time = point.seconds.isel(part=1 if quantity == "rate" else 0)
    options = {
        scheme: choose(
            point.steps.values.tolist(),
            bound.sel(scheme=scheme).values,
            float(point.deviation),
            time.sel(scheme=scheme).values,
            target,
        )
        for scheme in point.scheme.values
    }
    return min(options.items(), key=lambda item: item[1].seconds if item[1].steps else np.inf)


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
                cells.append(f"{name:5s}{_cell(one):30s}")
            lines.append(f"  {100.0 * target:4g} %  " + "".join(cells).rstrip())
    return lines


def _cell(one: xr.Dataset) -> str:
    seconds = float(one.seconds_of_regime)
    if not np.isfinite(seconds):
        return f"(reached at {100.0 * float(one.reached_of_regime):.0f} %)"
    steps, count = int(one.steps_of_regime), int(one.realizations_of_regime)
    return f"{steps}, {count}, {seconds:.2g} s"
