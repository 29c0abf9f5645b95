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

TILE_RATIOS = {  # estimate: sums of its ratio
    "mu_1": ("power", "load"),
    "mu_2": ("power_2", "load_2"),
    "jump": ("jump", "load"),
    "contact_fraction": ("touching", "load"),
}
MIN_LOADED_TILES = 2.0  # effective number
MIN_PATCHES = 3.0  # of contact: fewer are no sample of a rough surface, such as a single sphere
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
        for name, (part, load) in TILE_RATIOS.items():
            ratio = replicates(sums[part], 1) / replicates(sums[load], 1)
            spread = widening[:, None] * (ratio[:, 1:] / ratio[:, :1] - 1.0)
            value = scalars[name][:, None]
            values = np.hstack([value, np.where(value == 0.0, 0.0, value * (1.0 + spread))])
            if name in estimates:
                estimates[f"{name}_error"] = standard_error(values, 1)
            if name in blocks.carried:
                estimates[f"{name}_replicates"] = padded(values, JACKKNIFE_GROUPS)
