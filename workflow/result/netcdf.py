"""Result files: named, written durably, opened, checked, and compared with the study asked for.

The one place that knows that a result is netCDF.
"""

import contextlib
import json
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..ground import UserError
from ..simulate import CODE_HASH
from ..store import is_as_written
from ..study import AnyStudy
from ..system import program, replacing, unreadable

if TYPE_CHECKING:  # slow to import: plan and status do without
    import xarray as xr

SUFFIX = ".nc"
ROOT = ""  # the study itself among its groups; the others are its comparisons
MARKS = {"study", "code", "seed", "source"}  # attributes that every result has
# What a script raises that reads a result it was not made for, or one with a damaged variable.
BROKEN = (AttributeError, LookupError, MemoryError, OSError, RuntimeError, TypeError, ValueError)
NO_MATTER = ("cluster.",)  # settings that no number depends on
MORE_BYTES = 2**20  # than were written, to find out whether a disk is full
SHOWN = 5  # differing settings


def result_file(out: Path, study: AnyStudy) -> Path:
    """Return the result file of a study: ``out`` itself, or in the folder ``out``.

    Results of a scale lie beside that of the study as it stands, not in its place.
    """
    name = f"{study.name}-{study.scale}" if study.scale else study.name
    return out if out.suffix == SUFFIX else out / f"{name}{SUFFIX}"


def write_datasets(path: Path, datasets: Mapping[str, "xr.Dataset"]) -> None:
    """Write the study at the root of a netCDF file and each comparison as a group of it.

    Durably: readers keep the old file until the new one is whole. Raises UserError where the disk
    refuses it.
    """
    from xarray.backends import NetCDF4DataStore

    with replacing(path) as aside:
        try:
            for label, dataset in datasets.items():
                if label:  # CF: said at the root alone
                    dataset = dataset.assign_attrs()
                    dataset.attrs.pop("Conventions", None)
                mode, group = "a" if label else "w", label or None
                # A lock of ours: to_netcdf imports dask's scheduler to ask it for one.
                store = NetCDF4DataStore.open(str(aside), mode, group=group, lock=Lock())
                with contextlib.closing(store):
                    dataset.dump_to_store(store, encoding=_encoding(dataset))
        except (OSError, RuntimeError) as error:
            # HDF5 says "Permission denied", or nothing, where the disk is full: the disk says so
            # to a plain write of as much and more.
            size = aside.stat().st_size if aside.exists() else 0
            aside.write_bytes(bytes(size + MORE_BYTES))
            raise RuntimeError(str(error)) from error


def _encoding(dataset: "xr.Dataset") -> dict[str, Any]:
    """Return how variables are stored: with a checksum each, curves compressed.

    CF knows no whole numbers of 64 bits, and no gaps in the coordinates of dimensions.
    """
    found = {}
    for name, variable in dataset.variables.items():
        how: dict[str, Any] = {"fletcher32": variable.ndim > 0}
        if variable.ndim > 6:
            how |= {"zlib": True, "complevel": 1}
        if variable.dtype == np.int64:
            how["dtype"] = "int32"
        if name in dataset.dims:
            how["_FillValue"] = None
        found[str(name)] = how
    return found


def open_result(
    study: AnyStudy, path: Path, stack: contextlib.ExitStack
) -> dict[str, "xr.Dataset"]:
    """Return group -> dataset of a study's result, open until the stack is left.

    Raises UserError where the file is missing, damaged, or no result of such a study.
    """
    if path.is_symlink():
        raise UserError(f"{path}: is a link, which is not opened; name the file itself by --out")
    if not path.is_file():
        of = f" --scale {study.scale}" if study.scale else ""
        raise UserError(f"{path}: not found; first run: {program()} run {study.name}{of}")
    groups = {name.strip("/"): stack.enter_context(data) for name, data in _groups(path).items()}
    lacking = [axis for axis in study.axes if axis not in groups[ROOT].coords]
    if lacking:
        raise UserError(f"{path}: is no result of a grid: it has no axis {', '.join(lacking)}")
    return groups


def open_tree(path: str | os.PathLike[str]) -> "xr.DataTree":
    """Return a result file as a tree: the study at its root, each comparison a group.

    An axis on which a group has other values than the root bears the name of the group as well:
    ``published_speed``. Raises UserError where the file is missing, damaged, or no result of this
    program.
    """
    import xarray as xr

    if not isinstance(path, str | os.PathLike) or not Path(path).is_file():
        raise UserError(f"{path}: not found")
    groups = _groups(Path(path))
    root = groups["/"]
    return xr.DataTree.from_dict({name: _beside(root, name, data) for name, data in groups.items()})


def _beside(root: "xr.Dataset", name: str, data: "xr.Dataset") -> "xr.Dataset":
    """Return a group whose axes are those of the root or have other names, as a tree demands."""
    shared = root.sizes.keys() & data.sizes.keys()
    other = [axis for axis in shared if not root.get_index(axis).equals(data.get_index(axis))]
    return data.rename({axis: f"{name.strip('/')}_{axis}" for axis in other})


def _groups(path: Path) -> dict[str, "xr.Dataset"]:
    """Return group -> dataset of a result file. Raises UserError where it is none.

    One of which nobody knows that a run wrote it so is read by a process of its own first.
    """
    import xarray as xr

    if not is_as_written(path) and (why := unreadable([path])):
        raise UserError(f"{path}: cannot be read as netCDF: {why[path]}")
    try:
        groups: dict[str, xr.Dataset] = xr.open_groups(path, engine="netcdf4")
    except (AttributeError, OSError, RuntimeError, ValueError) as error:
        raise UserError(f"{path}: cannot be read as netCDF: {error}") from error
    root = groups["/"].attrs
    if not root.keys() >= MARKS or _flat(root["study"]) is None:
        raise UserError(f"{path}: is not a result of this program")
    return groups


class Peek(NamedTuple):
    """What a result says of itself at a glance."""

    attributes: dict[str, Any]
    realizations: dict[str, np.ndarray]  # of each point, by label of the variant


def peek(path: Path) -> Peek | None:
    """Return what a result says of itself, or None where it is none."""
    import netCDF4

    found = {}
    try:
        with netCDF4.Dataset(path) as file:
            file.set_auto_mask(False)
            attributes = {name: file.getncattr(name) for name in file.ncattrs()}
            for label, group in {ROOT: file, **file.groups}.items():
                found[label] = group["realizations"][:]
    except (AttributeError, LookupError, OSError, RuntimeError):
        return None
    return Peek(attributes, found)


def check_result(study: AnyStudy, path: Path, *, asked: bool) -> None:
    """Refuse a result that cannot be read; say where it is not that of the study as it stands.

    asked : whether the settings were given with the command, which a file of others contradicts.
    """
    with contextlib.ExitStack() as stack:
        attributes = open_result(study, path, stack)[ROOT].attrs
        settings = differing_settings(study, attributes)
        code = attributes["code"]
    if said := edited(path):
        print(f"note: {path}: {said}", file=sys.stderr)
    if settings:
        text = f"{path}: was computed with other settings than asked for: {listed(settings)}"
        if asked:
            raise UserError(f"{text}; run the study, or leave out --scale and --set")
        print(f"note: {text}; shown is the file", file=sys.stderr)
    if code != CODE_HASH:
        print(f"note: {path}: was computed by another version of the program", file=sys.stderr)


def edited(path: Path) -> str:
    """Return what is to be said of a result that is not as a run wrote it, or nothing."""
    said = "is not as a run wrote it: it was changed or replaced since; run the study again"
    return said if is_as_written(path) is False else ""


def broken(study: AnyStudy, path: Path, error: Exception) -> UserError:
    """Return what to raise where a script of the study cannot use its result."""
    reason = str(error).splitlines()[0] if str(error) else type(error).__name__
    return UserError(f"{path}: cannot be used by {study.name} ({reason:.200}); run the study again")


def differing_settings(study: AnyStudy, attributes: dict[str, Any]) -> list[str]:
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
