"""The arguments of a scene as the tables of a study, and the study that is read from them."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import UserError
from ..study import Profile, Study, given_profile, positive, read_grid_study

NAME = "scene"
OF_GRID = ("hurst", "roughness", "spacing")  # keys of random lines that a study has in [grid]
USUAL = ("steady", "trace")
SAMPLES = 200  # of a trace


def plain(value: Any) -> Any:
    """Return a value as TOML gives it: arrays and tuples as lists, numbers of numpy as numbers."""
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [plain(each) for each in value]
    return value.item() if isinstance(value, np.generic) else value


def table(name: str, value: Any) -> dict[str, Any]:
    """Return an argument that is a table, a copy. Raises UserError for anything else."""
    if not isinstance(value, Mapping):
        raise UserError(f"{name} = {value!r:.60}: must be a dictionary, with the keys of [{name}]")
    return plain(value)


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
        "seed": plain(arguments["seed"]),
        "realizations": plain(arguments["realizations"]),
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
    return given_profile(profile, positive("length", plain(length)))


def _scene(arguments: Mapping[str, Any], grid: dict[str, Any]) -> dict[str, Any]:
    """Return the table [scene]; what presses line and elastomer together goes into the grid."""
    force, depth = plain(arguments["normal_force"]), plain(arguments["prescribed_indentation"])
    if (force is None) == (depth is None):
        raise UserError("normal_force: give either normal_force or prescribed_indentation")
    names = ("quantities", "start", "repeat", "programme")
    found = {name: plain(arguments[name]) for name in names}
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


def identity(study: Study) -> str:
    """Return what two scenes must share for one to go on where the other ended."""
    tables = json.loads(study.text)
    kept = {name: tables.get(name) for name in ("material", "surface")}
    grid = {key: value for key, value in tables.get("grid", {}).items() if key in OF_GRID}
    profile = study.surface.profile.digest if study.surface.profile else ""
    numerics = study.variants[""]
    steps = numerics.scheme, numerics.steps_per_spacing
    return json.dumps([kept, grid, profile, study.seed, steps], sort_keys=True)
