"""Result files: written durably, opened, checked, and compared with the study asked for."""

import contextlib
import json
import os
import sys
from pathlib import Path

import dask
import xarray as xr

from workflow.errors import UserError
from workflow.simulate.code import CODE
from workflow.study.grid import AXES
from workflow.study.measured import Measured
from workflow.study.study import Study


def write_datasets(path: Path, datasets: dict[str, xr.Dataset]) -> None:
    """Write the study at the root of a netCDF file and each comparison as a group of it.

    The file is written aside and renamed: readers keep the old one until then.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with dask.config.set(scheduler="synchronous"):  # or xarray asks a scheduler for its lock
            for label, dataset in datasets.items():
                mode = "a" if label else "w"
                dataset.to_netcdf(aside, mode, group=label or None, encoding=_encoding(dataset))
        with aside.open("rb+") as file:
            os.fsync(file.fileno())
        aside.replace(path)
    except (OSError, RuntimeError) as error:  # HDF5 reports a full disk as RuntimeError
        with contextlib.suppress(OSError):
            aside.unlink()
        raise UserError(f"{path}: cannot be written: {error}") from error


def _encoding(dataset: xr.Dataset) -> dict:
    """Return how variables are stored: with a checksum each, curves compressed."""
    curve = {"zlib": True, "complevel": 1}
    return {
        name: {"fletcher32": variable.ndim > 0, **(curve if variable.ndim > 6 else {})}
        for name, variable in dataset.variables.items()
    }


ROOT = "/"  # group of the study itself
MARKS = {"study", "code", "seed", "source"}  # attributes that every result has


# What a script raises that reads a result it was not made for, or one with a damaged variable.
BROKEN = (AttributeError, LookupError, OSError, RuntimeError, TypeError, ValueError)
NO_MATTER = ("cluster.",)  # settings that no number depends on
SHOWN = 5  # differing settings


def open_result(
    study: Study | Measured, path: Path, stack: contextlib.ExitStack
) -> dict[str, xr.Dataset]:
    """Return group -> dataset of a study's result, open until the stack is left.

    Raises UserError where the file is missing, damaged, or no result of such a study.
    """
    if not path.is_file():
        raise UserError(f"{path}: not found; first run: python -m workflow run {study.name}")
    try:
        groups = xr.open_groups(path, engine="netcdf4")
    except (AttributeError, OSError, RuntimeError, ValueError) as error:
        raise UserError(f"{path}: cannot be read as netCDF: {error}") from error
    for dataset in groups.values():
        stack.enter_context(dataset)
    root = groups[ROOT]
    if not root.attrs.keys() >= MARKS or _flat(root.attrs["study"]) is None:
        raise UserError(f"{path}: is not a result of this program")
    axes = AXES if isinstance(study, Study) else ()
    lacking = [axis for axis in axes if axis not in root.coords]
    if lacking:
        raise UserError(f"{path}: is no result of a grid: it has no axis {', '.join(lacking)}")
    return groups


def check_result(study: Study | Measured, path: Path, *, asked: bool) -> None:
    """Refuse a result that cannot be read; say where it is not that of the study as it stands.

    asked : whether the settings were given with the command, which a file of others contradicts.
    """
    with contextlib.ExitStack() as stack:
        attributes = open_result(study, path, stack)[ROOT].attrs
        settings = differing_settings(study, attributes)
        code = attributes["code"]
    if settings:
        text = f"{path}: was computed with other settings than asked for: {listed(settings)}"
        if asked:
            raise UserError(f"{text}; run the study, or leave out --scale and --set")
        print(f"note: {text}; shown is the file", file=sys.stderr)
    if code != CODE:
        print(f"note: {path}: was computed by another version of the program", file=sys.stderr)


def broken(study: Study | Measured, path: Path, error: Exception) -> UserError:
    """Return what to raise where a script of the study cannot use its result."""
    reason = str(error).splitlines()[0] if str(error) else type(error).__name__
    return UserError(f"{path}: cannot be used by {study.name} ({reason:.200}); run the study again")


def differing_settings(study: Study | Measured, attributes: dict) -> list[str]:
    """Return the settings, as table.key, in which a result differs from a study."""
    ours, theirs = _flat(study.text) or {}, _flat(attributes["study"]) or {}
    keys = [key for key in sorted({*ours, *theirs}) if not key.startswith(NO_MATTER)]
    return [key for key in keys if ours.get(key) != theirs.get(key)]


def listed(settings: list[str]) -> str:
    """Return the settings as text, the first few of many."""
    more = f" and {len(settings) - SHOWN} more" if len(settings) > SHOWN else ""
    return ", ".join(settings[:SHOWN]) + more


def _flat(text: object) -> dict[str, object] | None:
    """Return table.key -> value of settings as JSON, or None where they are none."""
    try:
        tables = json.loads(str(text))
    except ValueError:
        return None
    if not isinstance(tables, dict) or not all(isinstance(t, dict) for t in tables.values()):
        return None
    return {f"{name}.{key}": table[key] for name, table in tables.items() for key in table}
