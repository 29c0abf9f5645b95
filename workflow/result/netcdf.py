"""Result files: names, durable writing, opening, checks, and comparison with a study.

Only this module knows that a result is netCDF.
"""

import contextlib
import json
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from threading import Lock
from typing import IO, TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..ground import UserError
from ..simulate import CODE_HASH
from ..store import is_as_written
from ..study import AnyStudy
from ..system import program, replacing, require_memory, unreadable

if TYPE_CHECKING:  # slow to import, and not needed by plan and status
    import netCDF4
    import xarray as xr

SUFFIX = ".nc"
ROOT = ""  # label of the study itself; the other groups are its comparisons
REQUIRED_ATTRIBUTES = {"study", "code", "seed", "source"}  # attributes that every result has
# Exceptions of a script that reads an unsuitable result or a damaged variable.
BROKEN = (AttributeError, LookupError, MemoryError, OSError, RuntimeError, TypeError, ValueError)
SETTINGS_WITHOUT_EFFECT = ("cluster.",)  # prefixes of settings that do not affect numbers
PROBE_BYTES = 2**20  # written to test whether the disk is full
COPIED_BYTES = 2**20  # copied at a time
HDF5_BYTES = 2**26  # HDF5 crashes or misreads a file if it cannot allocate what it needs
CACHE_BYTES = 2**20  # of HDF5 per variable; the default of 64 MiB each would add up
MAX_LISTED_SETTINGS = 5


def result_file(out: Path, study: AnyStudy) -> Path:
    """Return the result file of a study: ``out`` itself, or a file in the folder ``out``.

    Every scale has its own file, so that it does not replace the result of the default scale.
    """
    name = f"{study.name}-{study.scale}" if study.scale else study.name
    return out if out.suffix == SUFFIX else out / f"{name}{SUFFIX}"


def write_datasets(path: Path, datasets: Mapping[str, "xr.Dataset"]) -> None:
    """Write the study to the root of a netCDF file and each comparison to a group.

    The write is durable: readers see the old file until the new one is complete. Raises UserError
    if the disk refuses it.
    """
    from xarray.backends import NetCDF4DataStore

    require_memory(HDF5_BYTES)
    with replacing(path) as aside, _memory_file() as content:
        with _created(aside) as file:
            _redirect(aside, content)
            for label, dataset in datasets.items():
                if label:  # CF allows Conventions at the root only
                    dataset = dataset.assign_attrs()
                    dataset.attrs.pop("Conventions", None)
                group = file.createGroup(label) if label else file
                # Without this lock the store would import dask's scheduler to obtain one.
                store = NetCDF4DataStore(group, lock=Lock())
                dataset.dump_to_store(store, encoding=_encoding(dataset))
        content.seek(0)
        with aside.open("wb") as complete:
            shutil.copyfileobj(content, complete, COPIED_BYTES)


@contextlib.contextmanager
def _created(path: Path) -> Iterator["netCDF4.Dataset"]:
    """Create a netCDF file. Raises OSError, or RuntimeError if HDF5 gives no reason."""
    import netCDF4

    usual = netCDF4.get_chunk_cache()  # bytes for each variable, and further numbers
    netCDF4.set_chunk_cache(CACHE_BYTES)
    try:
        with netCDF4.Dataset(path, "w") as file:
            yield file
    except PermissionError as error:
        # HDF5 reports a full disk in this way; a plain write raises the true error.
        path.write_bytes(bytes(PROBE_BYTES))
        raise RuntimeError(str(error)) from error
    finally:
        netCDF4.set_chunk_cache(*usual)


def _memory_file() -> IO[bytes]:
    """Return an open file in memory, or a temporary file on systems without them."""
    if hasattr(os, "memfd_create"):
        return os.fdopen(os.memfd_create("result"), "w+b")
    return tempfile.TemporaryFile()


def _redirect(path: Path, content: IO[bytes]) -> None:
    """Let the descriptor by which HDF5 has opened a new file write to ``content`` instead.

    HDF5 ends the process (SIGSEGV) if its last writes to a disk fail. The memory files of netCDF4
    itself contain the time and forget the order of the variables.
    """
    content.write(path.read_bytes())
    content.flush()
    for entry in Path("/dev/fd").iterdir():
        descriptor = int(entry.name)
        with contextlib.suppress(OSError):  # that of the folder itself is closed
            if os.path.samestat(os.fstat(descriptor), path.stat()):
                os.dup2(content.fileno(), descriptor, inheritable=False)


def _encoding(dataset: "xr.Dataset") -> dict[str, Any]:
    """Return the encoding of the variables: checksums for arrays, compression for curves.

    CF allows neither 64-bit integers nor missing values in the coordinates of dimensions.
    """
    encoding = {}
    for name, variable in dataset.variables.items():
        options: dict[str, Any] = {"fletcher32": variable.ndim > 0}
        if variable.ndim > 6:
            options |= {"zlib": True, "complevel": 1}
        if variable.dtype == np.int64:
            options["dtype"] = "int32"
        if name in dataset.dims:
            options["_FillValue"] = None
        encoding[str(name)] = options
    return encoding


def open_result(
    study: AnyStudy, path: Path, stack: contextlib.ExitStack
) -> dict[str, "xr.Dataset"]:
    """Return group -> dataset of a study's result; the datasets close with the stack.

    Raises UserError if the file is missing, a symbolic link, damaged, or lacks an axis.
    """
    if path.is_symlink():
        raise UserError(
            f"{path}: is a symbolic link, which is not opened; give the file itself with --out"
        )
    if not path.is_file():
        scale = f" --scale {study.scale}" if study.scale else ""
        raise UserError(f"{path}: not found; first run: {program()} run {study.name}{scale}")
    groups = {name.strip("/"): stack.enter_context(data) for name, data in _groups(path).items()}
    missing = [axis for axis in study.axes if axis not in groups[ROOT].coords]
    if missing:
        raise UserError(f"{path}: is not a result of a grid: it lacks axis {', '.join(missing)}")
    return groups


def open_tree(path: str | os.PathLike[str]) -> "xr.DataTree":
    """Return a result file as a tree: the study at the root, each comparison as a group.

    An axis whose values in a group differ from those at the root gets the name of the group as a
    prefix, as in ``published_speed``. Raises UserError if the file is missing, damaged, or not a
    result of this program.
    """
    import xarray as xr

    if not isinstance(path, str | os.PathLike) or not Path(path).is_file():
        raise UserError(f"{path}: not found")
    groups = _groups(Path(path))
    root = groups["/"]
    return xr.DataTree.from_dict(
        {name: _with_distinct_axes(root, name, data) for name, data in groups.items()}
    )


def _with_distinct_axes(root: "xr.Dataset", name: str, data: "xr.Dataset") -> "xr.Dataset":
    """Return a group with axes renamed where they differ from the root, as DataTree requires."""
    shared = root.sizes.keys() & data.sizes.keys()
    other = [axis for axis in shared if not root.get_index(axis).equals(data.get_index(axis))]
    return data.rename({axis: f"{name.strip('/')}_{axis}" for axis in other})


def _groups(path: Path) -> dict[str, "xr.Dataset"]:
    """Return group -> dataset of a result file. Raises UserError if it is not one.

    A file not known to be written by a run is first read in a sandboxed process.
    """
    import xarray as xr

    require_memory(HDF5_BYTES)
    if not is_as_written(path) and (why := unreadable([path])):
        raise UserError(f"{path}: cannot be read as netCDF: {why[path]}")
    try:
        groups: dict[str, xr.Dataset] = xr.open_groups(path, engine="netcdf4")
    except (AttributeError, OSError, RuntimeError, ValueError) as error:
        raise UserError(f"{path}: cannot be read as netCDF: {error}") from error
    root = groups["/"].attrs
    if not root.keys() >= REQUIRED_ATTRIBUTES or _flat(root["study"]) is None:
        raise UserError(f"{path}: is not a result of this program")
    return groups


class Peek(NamedTuple):
    """Attributes of a result file, and its numbers of realizations."""

    attributes: dict[str, Any]
    realizations: dict[str, np.ndarray]  # at all points, by label of the variant
    model_realizations: np.ndarray | None  # of the other body


def peek(path: Path) -> Peek | None:
    """Return the Peek of a file, or None if it is not a result."""
    import netCDF4

    realizations = {}
    try:
        with netCDF4.Dataset(path) as file:
            file.set_auto_mask(False)
            attributes = {name: file.getncattr(name) for name in file.ncattrs()}
            for label, group in {ROOT: file, **file.groups}.items():
                if "realizations" in group.variables:
                    realizations[label] = group["realizations"][:]
            name = "model_realizations"
            other = file[name][:] if name in file.variables else None
    except (AttributeError, LookupError, OSError, RuntimeError):
        return None
    return Peek(attributes, realizations, other)


def check_result(study: AnyStudy, path: Path, *, strict: bool) -> None:
    """Raise UserError for an unreadable result, and print a note if its settings differ.

    strict : also raise UserError for differing settings (given on the command line).
    """
    with contextlib.ExitStack() as stack:
        attributes = open_result(study, path, stack)[ROOT].attrs
        settings = differing_settings(study, attributes)
        code = attributes["code"]
    if note := change_note(path):
        print(f"note: {path}: {note}", file=sys.stderr)
    if settings:
        if "study.title" in settings:
            other = f"is the result of another study, {attributes['title']!r:.80}"
            raise UserError(f"{path}: {other}; run this study, with another --out")
        text = f"{path}: was computed with other settings than requested: {listed(settings)}"
        if strict:
            raise UserError(f"{text}; run the study, or leave out --scale and --set")
        print(f"note: {text}; the figure shows the file", file=sys.stderr)
    if code != CODE_HASH:
        print(f"note: {path}: was computed by another version of the program", file=sys.stderr)


def change_note(path: Path) -> str:
    """Return a note if a result was changed since a run wrote it, or ""."""
    note = "was changed or replaced since a run wrote it; run the study again"
    return note if is_as_written(path) is False else ""


def broken(study: AnyStudy, path: Path, error: Exception) -> UserError:
    """Return the UserError for a script of the study that cannot use its result."""
    reason = str(error).splitlines()[0] if str(error) else type(error).__name__
    return UserError(f"{path}: cannot be used by {study.name} ({reason:.200}); run the study again")


def differing_settings(study: AnyStudy, attributes: dict[str, Any]) -> list[str]:
    """Return the settings (table.key) that differ between a result and a study."""
    ours, theirs = _flat(study.text) or {}, _flat(attributes["study"]) or {}
    keys = [key for key in sorted({*ours, *theirs}) if not key.startswith(SETTINGS_WITHOUT_EFFECT)]
    return [key for key in keys if ours.get(key) != theirs.get(key)]


def listed(settings: list[str]) -> str:
    """Return the first settings as text, with the number of the others."""
    text, more = ", ".join(settings[:MAX_LISTED_SETTINGS]), len(settings) - MAX_LISTED_SETTINGS
    return f"{text} and {more} more" if more > 0 else text


def _flat(text: object) -> dict[str, object] | None:
    """Return table.key -> value of settings in JSON, or None if the text holds none."""
    try:
        tables = json.loads(str(text))
    except ValueError:
        return None
    if not isinstance(tables, dict) or not all(isinstance(t, dict) for t in tables.values()):
        return None
    return {f"{name}.{key}": table[key] for name, table in tables.items() for key in table}
