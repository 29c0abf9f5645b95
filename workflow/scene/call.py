"""The call by which a scene is run from Python."""

from collections.abc import Mapping, Sequence
from typing import Any

import xarray as xr

from .alone import computed
from .arguments import USUAL, identity, study_of
from .resume import marked, saved_state


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
    return marked(computed(study, resumed), identity(study))
