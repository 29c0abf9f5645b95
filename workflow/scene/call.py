"""Run a scene from Python: one point, computed in the calling process, and its dataset."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ...kernels import ZERO_ORIGIN, SavedState, form_of, memory_size
from ...kernels.compile import cache
from ..ground import UserError
from ..plan import Plan, Variant, cut, make_batches, make_plan, missing_work
from ..reduce import BlockPlace, Estimates, Portion, completed, reduce_portion, reduction_of
from ..result import build_dataset
from ..simulate import block_means
from ..study import (
    HALF_SPACE,
    PROGRAMME_AXES,
    Profile,
    Study,
    positive,
    profile_of_array,
    read_grid_study,
    sampled_motion,
)
from ..system import import_dask, report_compilation

SCENE_STUDY_NAME = "scene"
GRID_KEYS = ("hurst", "roughness", "spacing")  # keys of surface that belong to [grid]
TRACE_SAMPLES = 200
LOAD_KEYS = ("normal_force", "normal_pressure", "prescribed_indentation")
STATE_VARIABLES = {name: f"state_{name}" for name in SavedState._fields}
ORIGIN_ATTRIBUTE = "scene"  # attribute that identifies line and material of a state


def toml_value(name: str, value: Any) -> Any:
    """Convert arrays and tuples to lists, and numpy scalars to numbers, as in TOML.

    Raises UserError, naming the argument, for masked values, numpy dates and recursive structures.
    """
    if np.ma.is_masked(value):
        raise UserError(f"{name}: holds masked values; fill or remove them")
    try:
        if isinstance(value, Mapping):
            return {str(key): toml_value(name, item) for key, item in value.items()}
        if isinstance(value, np.ndarray | np.generic | xr.DataArray):
            if value.dtype.kind in "mM":
                raise UserError(f"{name}: holds dates or timedelta64; give times as numbers in s")
            return np.asarray(value).tolist()
        if isinstance(value, list | tuple):
            return [toml_value(name, item) for item in value]
    except RecursionError:
        raise UserError(f"{name}: holds itself; remove the recursion") from None
    return value


def table(name: str, value: Any) -> dict[str, Any]:
    """Return a copy of an argument that is a table. Raises UserError for another type."""
    if not isinstance(value, Mapping):
        raise UserError(f"{name} = {value!r:.60}: must be a dictionary, with the keys of [{name}]")
    return toml_value(name, value)


def study_of(arguments: Mapping[str, Any]) -> Study:
    """Return the study of one point that the arguments of ``run`` describe. Raises UserError."""
    grid: dict[str, Any] = {}
    tables: dict[str, Any] = {"material": table("material", arguments["material"]), "grid": grid}
    profile = _profile(arguments)
    if profile is None:
        surface = table("surface", arguments["surface"])
        grid |= {key: surface.pop(key) for key in GRID_KEYS if key in surface}
        tables["surface"] = surface
    tables["numerics"] = {"samples": TRACE_SAMPLES}
    if arguments["numerics"] is not None:
        tables["numerics"] |= table("numerics", arguments["numerics"])
    tables["scene"] = _scene(arguments, grid)
    tables["study"] = {
        "title": SCENE_STUDY_NAME,
        **{name: toml_value(name, arguments[name]) for name in ("seed", "realizations")},
    }
    return read_grid_study(SCENE_STUDY_NAME, Path(), tables, one_point=True, profile=profile)


def _profile(arguments: Mapping[str, Any]) -> Profile | None:
    """Return the given profile, or None for random lines. Raises UserError."""
    profile, length = arguments["profile"], arguments["length"]
    if (profile is None) == (arguments["surface"] is None):
        raise UserError("profile: give either profile and length, or surface")
    if profile is None:
        if length is not None:
            raise UserError(
                f"length = {length!r}: belongs to a profile; give surface.length instead"
            )
        return None
    if length is None:
        raise UserError("length: missing; give the period of the profile in m")
    body = toml_value("body", arguments["body"])
    if body is None and arguments["prescribed_indentation"] is None and _is_square(profile):
        body = HALF_SPACE
    period = positive("length", toml_value("length", length))
    return profile_of_array(profile, period, as_map=body == HALF_SPACE)


def _is_square(profile: Any) -> bool:
    """Return whether heights are a map: as many rows as samples."""
    shape = np.shape(profile)
    return len(shape) == 2 and shape[0] == shape[1]


def _scene(arguments: Mapping[str, Any], grid: dict[str, Any]) -> dict[str, Any]:
    """Return the table [scene]; add the load or the indentation to the grid."""
    given = {key: arguments[key] for key in LOAD_KEYS if arguments[key] is not None}
    load = {key: toml_value(key, value) for key, value in given.items()}
    if len(load) != 1:
        raise UserError(f"normal_force: give one of {', '.join(LOAD_KEYS)}")
    depth = load.get("prescribed_indentation")
    names = ("quantities", "start", "repeat", "body")
    scene = {name: toml_value(name, arguments[name]) for name in names}
    scene = {name: value for name, value in scene.items() if value is not None}
    scene["programme"] = _programme(arguments)
    for name in ("drive", "shear", "heat"):
        if arguments[name] is not None:
            scene[name] = table(name, arguments[name])
    if depth is not None:
        scene["control"] = "indentation"
    if isinstance(depth, str):
        scene["indentation_file"] = depth
    else:
        grid |= load
    return scene


def _programme(arguments: Mapping[str, Any]) -> Any:
    """Return the programme as in [scene], a function of time as samples. Raises UserError."""
    programme, duration = arguments["programme"], arguments["duration"]
    if not callable(programme):
        if duration is not None:
            raise UserError(
                f"duration = {duration!r}: belongs to a programme that is a function of time; give "
                "the duration of each segment"
            )
        return toml_value("programme", programme)
    if duration is None:
        raise UserError("duration: missing; give the time in s for which the function holds")
    motion = sampled_motion(programme, positive("duration", toml_value("duration", duration)))
    return motion if arguments["drive"] is None else {"pull": motion}


def line_and_material(study: Study) -> str:
    """Return a text that identifies line, material and time steps; continued scenes share it."""
    tables = json.loads(study.text)
    shared = {name: tables.get(name) for name in ("material", "surface")}
    grid = {key: value for key, value in tables.get("grid", {}).items() if key in GRID_KEYS}
    profile = study.surface.profile
    heights = profile.digest if profile else study.surface.identity
    numerics = study.variants[""]
    steps = numerics.scheme, numerics.steps_per_spacing
    return json.dumps([shared, grid, heights, study.seed, steps], sort_keys=True)


def saved_state(state: xr.Dataset, study: Study) -> SavedState:
    """Return the state stored in a dataset. Raises UserError if the scene cannot continue it."""
    if not isinstance(state, xr.Dataset):
        raise UserError(f'state = {state!r:.60}: must be a dataset of the quantity "state"')
    missing = [name for name in STATE_VARIABLES.values() if name not in state]
    if missing:
        raise UserError(
            f'state: {missing[0]} is missing; request the quantity "state" in the previous run'
        )
    if state.attrs.get(ORIGIN_ATTRIBUTE) != line_and_material(study):
        raise UserError(
            "state: belongs to another line, material, seed, scheme or steps per spacing; continue "
            "with those of the previous run"
        )
    if study.realizations != 1:
        raise UserError(
            f"realizations = {study.realizations_requested}: a state is that of one line"
        )
    numerics = study.variants[""]
    units = memory_size(form_of(study.material.spectrum(), numerics.scheme))
    memory = np.ascontiguousarray(state["state_memory"].values[:units])
    numbers = {
        name: float(state[STATE_VARIABLES[name]]) for name in ("d", "position", "time", "speed")
    }
    return SavedState(memory=memory, p=np.ascontiguousarray(state["state_p"].values), **numbers)


PER_TAU = ("relaxation_rate", "relaxation_rate_free", "stretched_rate", "fast_rate", "slow_rate")
IN_TAU = ("time", "fit_window")


def compute(study: Study, resumed: SavedState | None = None) -> xr.Dataset:
    """Compute the dataset of a study of one point, without grid dimensions, times in s.

    resumed : state of a single line from which the programme continues; by default the initial
    state of the study. A note on the standard error stream announces the compilation of kernels.
    Raises UserError for a refused plan, and ValueError as the kernels do.
    """
    plan = make_plan(study, origin=resumed.origin if resumed else ZERO_ORIGIN)
    variant, other_body = plan.variants[0], plan.other_body
    with report_compilation("the kernels of this scene", "5 to 60 s", cache.WAITING_EVENT):
        other = _estimates(plan, other_body, None) if other_body else None
        estimates = _estimates(plan, variant, resumed, other)
    dataset = build_dataset(plan, variant, estimates, {})
    single = {axis: 0 for axis in study.axes if axis not in PROGRAMME_AXES}
    return _in_seconds(dataset.isel(single), study)


def _estimates(
    plan: Plan, variant: Variant, resumed: SavedState | None, other: Estimates | None = None
) -> Estimates:
    """Return the estimates of all tasks of a variant. other : as for ``completed``."""
    tasks, blocks = variant.tasks, max(plan.expected[task.key] for task in variant.tasks)
    missing = [entry for entry in missing_work(plan, ()) if entry.variant is variant]
    places, results = [], []
    for batch in make_batches(cut(missing, np.inf), 1e9):
        results.append(block_means(replace(batch, resumed=resumed)))
        columns = {task.key: column for column, task in enumerate(batch.tasks)}
        places.append(
            [
                BlockPlace(row, columns[task.key], batch.first_block, batch.blocks)
                for row, task in enumerate(tasks)
                if task.key in columns
            ]
        )
    how, width = reduction_of(variant), plan.widest_row(variant)
    portion = Portion(how, tasks, [blocks] * len(tasks), blocks, width, places, [])
    estimates, _ = reduce_portion(portion, *results)
    counts = np.full(len(tasks), blocks * variant.block_size, np.int32)
    estimates.pop("rate_replicates", None)  # serve only fits over many points
    return completed(plan, variant, estimates, np.arange(len(tasks)), counts, other)


def _in_seconds(dataset: xr.Dataset, study: Study) -> xr.Dataset:
    """Return the dataset with times in s and rates in 1/s, without coordinates that are NaN."""
    tau, converted = study.material.tau, {}
    for name in (*dataset.data_vars, *dataset.coords.keys() & {*IN_TAU}):
        variable = dataset[name]
        base = str(name).removesuffix("_error")
        if base in IN_TAU or base in PER_TAU:
            scale, unit = (tau, "s") if base in IN_TAU else (1.0 / tau, "s-1")
            long_name = variable.attrs["long_name"].replace(", (t - t0)/tau", "")
            long_name = long_name.replace(", per tau", "").replace(" in tau", "")
            attributes = {**variable.attrs, "units": unit, "long_name": long_name}
            converted[name] = (variable * scale).assign_attrs(attributes)
    undefined = [name for name, axis in dataset.coords.items() if axis.ndim == 0 and np.isnan(axis)]
    return dataset.assign(converted).drop_vars(undefined)


def run(
    *,
    profile: Any = None,
    length: float | None = None,
    surface: Mapping[str, Any] | None = None,
    material: Mapping[str, Any],
    normal_force: float | None = None,
    normal_pressure: float | None = None,
    prescribed_indentation: float | str | None = None,
    programme: Sequence[Mapping[str, Any]] | Mapping[str, Any] | Callable[[float], float],
    duration: float | None = None,
    drive: Mapping[str, Any] | None = None,
    shear: Mapping[str, Any] | None = None,
    heat: Mapping[str, Any] | None = None,
    body: str | None = None,
    start: str = "steady",
    repeat: int = 1,
    quantities: Sequence[str] | None = None,
    numerics: Mapping[str, Any] | None = None,
    realizations: int = 1,
    seed: int = 0,
    state: xr.Dataset | None = None,
) -> xr.Dataset:
    """Slide a rigid line over an elastomer by a programme of motion; all values in SI units.

    profile : heights (m) of one period, shape (n,) or (lines, n), used without preparation. On a
        half-space: a map (n, n) with the last axis along x, or (n,) for a line contact. Of a
        rectangular map the square at its centre is used.
    length : length of that period (m).
    surface : random lines in place of a profile, described by the keys of the table [surface] and
        by spacing, hurst and roughness as in [grid]; the last two are left out with spectrum.
    material, numerics : keys of the tables [material] and [numerics].
    normal_force : load (N). Alternatives are normal_pressure (Pa) and prescribed_indentation: that
        of the mean line (m), or the name of a file of times (s) and indentations (m).
    drive : keys of [scene.drive], for a programme of segments ``pull``.
    shear : keys of [scene.shear], the shear stress of the real contact of a half-space.
    heat : keys of [scene.heat], by which friction warms the contact of a half-space.
    body : "foundation" or "half-space"; by default a half-space for a square profile and for a
        surface under normal_pressure, else the foundation.
    programme : list of segments, each as in [[scene.programme]] or {"time": ..., "velocity": ...}
        with arrays in s and m/s; a single segment; or a function of the time (s) that returns the
        velocity (m/s) of the line or of the drive, sampled until lines between the samples miss it
        by at most 1e-4 of the largest speed. duration : time (s) that such a function covers.
    start, repeat, quantities : as in [scene].
    realizations : number of lines; several lines give standard errors. seed : of random lines.
    state : dataset with the quantity "state", from which the programme continues exactly.

    Returns a dataset with the variables and the provenance of a result file (docs/scenes.md),
    without dimensions of the grid, times in s. Raises UserError, one line, for invalid input.
    """
    arguments = dict(locals())
    import_dask()
    study = study_of(arguments)
    resumed = None if state is None else saved_state(state, study)
    dataset = compute(study, resumed)
    if "state_memory" in dataset:
        dataset.attrs[ORIGIN_ATTRIBUTE] = line_and_material(study)
    return dataset
