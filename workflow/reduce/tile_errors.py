"""Standard errors of a single map, by a jackknife over its tiles.

Each estimate is the ratio of a sum over the map to the normal force, and a replicate leaves out one
tile, which is wider than the mean wave of the heights. As tiles carry the load unequally, the
error is widened by Student's t for their effective number: one error then covers 68 %.
Source: B. Efron, The Jackknife, the Bootstrap and Other Resampling Plans (SIAM 1982), ch. 3.
"""

import numpy as np
from scipy.special import ndtr, stdtrit

from ...kernels.half_space.tiles import TILE_SUMS
from ..plan import JACKKNIFE_GROUPS
from ..simulate import SCALARS
from .blocks import Blocks, Estimates
from .jackknife import padded, replicates, standard_error

TILE_RATIOS = {  # estimate -> numerator and denominator
    "mu_1": ("power", "load"),
    "mu_2": ("power_2", "load_2"),
    "jump": ("jump", "load"),
    "contact_fraction": ("touching", "load"),
}
SHEAR_RATIOS = {  # of the shear parts
    "mu_1": ("touching", "load"),
    "mu_2": ("touching_2", "load_2"),
    "jump": ("touching", "load"),
}
MIN_LOADED_TILES = 2.0  # effective number
MIN_PATCHES = 3.0  # fewer, as for a sphere, do not represent a rough surface
MAX_PARTIAL_CONTACT = 0.5  # contact fraction up to which the number of patches counts


def enter_tile_errors(estimates: Estimates, blocks: Blocks) -> None:
    """Store the standard errors of single maps, and the replicates of ``blocks.carried``.

    An error is NaN if the load rests on too few tiles or patches to estimate it.
    """
    scalars = dict(zip(SCALARS, blocks.scalars[:, 0].T, strict=True))
    tiles = blocks.values["tiles"][:, 0].reshape(len(blocks.scalars), len(TILE_SUMS), -1)
    sums = dict(zip(TILE_SUMS, np.moveaxis(tiles, 1, 0), strict=True))
    estimates["degrees_of_freedom"][:] = tiles.shape[-1] - 1
    with np.errstate(all="ignore"):
        share = sums["load"] / sums["load"].sum(axis=1, keepdims=True)
        loaded = 1.0 / np.sum(share**2, axis=1)
        patches = sums["touching"].sum(axis=1) / scalars["samples_per_contact"]
        sampled = (patches >= MIN_PATCHES) | (scalars["contact_fraction"] > MAX_PARTIAL_CONTACT)
        sampled &= loaded >= MIN_LOADED_TILES
        widening = np.where(sampled, stdtrit(loaded - 1.0, ndtr(1.0)), np.nan)

        def spread(value: np.ndarray, part: str, load: str) -> np.ndarray:
            """Return the value and its replicates over tiles, with the scatter of a ratio."""
            ratio = replicates(sums[part], 1) / replicates(sums[load], 1)
            change = widening[:, None] * (ratio[:, 1:] / ratio[:, :1] - 1.0)
            return np.hstack([value, np.where(value == 0.0, 0.0, value * (1.0 + change))])

        parts = blocks.parts or {}
        for name, ratio in TILE_RATIOS.items():
            values = {name: spread(scalars[name][:, None], *ratio)}
            if f"{name}_shear" in parts:
                ratios = {f"{name}_viscoelastic": ratio, f"{name}_shear": SHEAR_RATIOS[name]}
                values = {part: spread(parts[part], *sides) for part, sides in ratios.items()}
                values[name] = np.sum(list(values.values()), axis=0)
            for part in values.keys() & estimates.keys():
                estimates[f"{part}_error"] = standard_error(values[part], 1)
            if name in blocks.carried:
                estimates[f"{name}_replicates"] = padded(values[name], JACKKNIFE_GROUPS)
