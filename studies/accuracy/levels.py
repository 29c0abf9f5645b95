"""Multilevel Monte Carlo over m: many coarse and few fine realizations on the same lines.

mean Q_M = mean Q_m0 + sum mean (Q_m - Q_m') over levels m' < m. With variances V and costs C per
level the best numbers of realizations give a variance of (sum sqrt(V C))^2 / cost in all.
Source: M. B. Giles, Multilevel Monte Carlo path simulation, Oper. Res. 56, 607 (2008).
"""

from itertools import combinations, pairwise

import numpy as np

from .errors import Observed

CHAIN = 4  # levels at most


def influence(found: Observed) -> dict[str, np.ndarray]:
    """Return per quantity what each line adds to the estimate, relative: shape (lines,).

    Of the rate, a function of the mean curve: its jackknife pseudo-values.
    """
    count = found.mu_1.size
    rate = (count * found.rate[0] - (count - 1) * found.rate[1:]) / found.rate[0]
    return {
        "mu_1": found.mu_1 / found.mu_1.mean(),
        "jump": found.jump / found.jump.mean(),
        "rate": rate,
    }


def multilevel_gain(
    values: dict[int, np.ndarray], bias: dict[int, float], cost: dict[int, float], target: float
) -> float:
    """Return the cost of plain Monte Carlo over that of the multilevel one, at equal error.

    values : per m one value per line, the same lines for all m (a finer m may have fewer).
    bias : of the mean, relative. cost : seconds per realization. target : relative error.
    Plain Monte Carlo takes the best single m. NaN where no m has a small enough bias.
    """
    plain, levels = np.inf, np.inf
    usable = sorted(m for m in values if np.isfinite(values[m]).all())
    for top in usable:
        room = target**2 - bias[top] ** 2
        if not room > 0.0:
            continue
        plain = min(plain, values[top].var(ddof=1) * cost[top] / room)
        below = [m for m in usable if m < top]
        for length in range(1, CHAIN):
            for chain in combinations(below, length):
                levels = min(levels, _work((*chain, top), values, cost) / room)
    return float(plain / min(levels, plain)) if np.isfinite(plain) else np.nan


def _work(chain: tuple[int, ...], values: dict[int, np.ndarray], cost: dict[int, float]) -> float:
    """Return (sum over levels of sqrt(V C))^2."""
    total = np.sqrt(values[chain[0]].var(ddof=1) * cost[chain[0]])
    for coarse, fine in pairwise(chain):
        count = min(values[coarse].size, values[fine].size)
        apart = values[fine][:count] - values[coarse][:count]
        total += np.sqrt(apart.var(ddof=1) * (cost[coarse] + cost[fine]))
    return float(total**2)
