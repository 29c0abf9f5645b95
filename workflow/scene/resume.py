"""Go on where another scene ended: its state is what elements and line remember, no more."""

import numpy as np
import xarray as xr

from ...kernels import Saved, form_of, memories
from ..errors import UserError
from ..study import Study
from .arguments import identity

FIELDS = {name: f"state_{name}" for name in Saved._fields}
MARK = "scene"  # attribute that tells of which line and material a state is


def marked(dataset: xr.Dataset, mark: str) -> xr.Dataset:
    """Return a dataset that says to which scenes its state belongs."""
    return dataset.assign_attrs({MARK: mark}) if "state_memory" in dataset else dataset


def saved_state(state: xr.Dataset, study: Study) -> Saved:
    """Return the state that a dataset holds. Raises UserError for one of another scene."""
    missing = [name for name in FIELDS.values() if name not in state]
    if missing:
        raise UserError(
            f'state: holds no {missing[0]}; ask for the quantity "state" in the run before'
        )
    if state.attrs.get(MARK) != identity(study):
        raise UserError(
            "state: belongs to another line, material, seed, scheme or steps per spacing; go on "
            "with those of the run before"
        )
    if study.realizations != 1:
        raise UserError(f"realizations = {study.realizations_asked}: a state is that of one line")
    numerics = study.variants[""]
    units = memories(form_of(study.material.spectrum(), numerics.scheme))
    memory = np.ascontiguousarray(state["state_memory"].values[:units])
    numbers = {name: float(state[FIELDS[name]]) for name in ("d", "position", "time", "speed")}
    return Saved(memory=memory, p=np.ascontiguousarray(state["state_p"].values), **numbers)
