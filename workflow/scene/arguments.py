"""The arguments of a scene as the tables of a study, and the state from which a scene goes on.

A state is what elements and line remember, no more.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ...kernels import Saved, form_of, memories
from ..errors import UserError
from ..study import Profile, Study, given_profile, positive, read_grid_study

NAME = "scene"
OF_GRID = ("hurst", "roughness", "spacing")  # keys of random lines that a study has in [grid]
USUAL = ("steady", "trace")
SAMPLES = 200  # of a trace
FIELDS = {name: f"state_{name}" for name in Saved._fields}
MARK = "scene"  # attribute that tells of which line and material a state is


def toml_value(value: Any) -> Any:
    """Return a value as TOML gives it: arrays and tuples as lists, numbers of numpy as numbers."""
    if isinstance(value, Mapping):
        return {str(key): toml_value(each) for key, each in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [toml_value(each) for each in value]
    return value.item() if isinstance(value, np.generic) else value


def table(name: str, value: Any) -> dict[str, Any]:
    """Return an argument that is a table, a copy. Raises UserError for anything else."""
    if not isinstance(value, Mapping):
        raise UserError(f"{name} = {value!r:.60}: must be a dictionary, with the keys of [{name}]")
    return toml_value(value)


def study_of(arguments: Mapping[str, Any]) -> Study:
    """Return the study of one point that the arguments of ``run`` describe. Raises UserError."""
    numerics = {"samples": SAMPLES}
    grid: dict[str, Any] = {}
    tables: dict[str, Any] = {"material": table("material", arguments["material"]), "grid": grid}
    profile = _profile(arguments)
    if profile is None:
        surface = table("surface", arguments["surface"])
        grid |= {key: surface.pop(key) for key in OF_GRID if key in surface}
        tables["surface"] = surface
    else:
        numerics["steps_per_spacing"] = 1
    if arguments["numerics"] is not None:
        given = table("numerics", arguments["numerics"])
        numerics |= given
    tables["numerics"] = numerics
    tables["scene"] = _scene(arguments, grid)
    tables["study"] = {
        "title": NAME,
        "seed": toml_value(arguments["seed"]),
        "realizations": toml_value(arguments["realizations"]),
    }
    return read_grid_study(NAME, Path(), tables, one_point=True, profile=profile)


def _profile(arguments: Mapping[str, Any]) -> Profile | None:
    """Return the profile that is given, or None where lines are random. Raises UserError."""
    profile, length = arguments["profile"], arguments["length"]
    if (profile is None) == (arguments["surface"] is None):
        raise UserError("profile: give either profile and length, or surface")
    if profile is None:
        if length is not None:
            raise UserError(f"length = {length!r}: belongs to a profile; give surface.length")
        return None
    if length is None:
        raise UserError("length: missing; it is that of the profile, one period, in m")
    return given_profile(profile, positive("length", toml_value(length)))


def _scene(arguments: Mapping[str, Any], grid: dict[str, Any]) -> dict[str, Any]:
    """Return the table [scene]; what presses line and elastomer together goes into the grid."""
    force, depth = (
        toml_value(arguments["normal_force"]),
        toml_value(arguments["prescribed_indentation"]),
    )
    if (force is None) == (depth is None):
        raise UserError("normal_force: give either normal_force or prescribed_indentation")
    names = ("quantities", "start", "repeat", "programme")
    found = {name: toml_value(arguments[name]) for name in names}
    if depth is not None and tuple(found["quantities"]) == USUAL:
        found["quantities"] = ["trace"]  # there is no steady sliding under a given force
    if force is not None:
        grid["normal_force"] = force
    elif isinstance(depth, str):
        found |= {"control": "indentation", "indentation_file": depth}
    else:
        found["control"] = "indentation"
        grid["prescribed_indentation"] = depth
    return found


def line_and_material(study: Study) -> str:
    """Return what two scenes must share for one to go on where the other ended."""
    tables = json.loads(study.text)
    kept = {name: tables.get(name) for name in ("material", "surface")}
    grid = {key: value for key, value in tables.get("grid", {}).items() if key in OF_GRID}
    profile = study.surface.profile.digest if study.surface.profile else ""
    numerics = study.variants[""]
    steps = numerics.scheme, numerics.steps_per_spacing
    return json.dumps([kept, grid, profile, study.seed, steps], sort_keys=True)


def with_mark(dataset: xr.Dataset, mark: str) -> xr.Dataset:
    """Return a dataset that says to which scenes its state belongs."""
    return dataset.assign_attrs({MARK: mark}) if "state_memory" in dataset else dataset


def saved_state(state: xr.Dataset, study: Study) -> Saved:
    """Return the state that a dataset holds. Raises UserError for one of another scene."""
    missing = [name for name in FIELDS.values() if name not in state]
    if missing:
        raise UserError(
            f'state: holds no {missing[0]}; ask for the quantity "state" in the run before'
        )
    if state.attrs.get(MARK) != line_and_material(study):
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
