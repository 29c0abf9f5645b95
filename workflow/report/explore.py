"""One page of HTML on which a result is looked through: no server, no network, nothing else.

The page holds the numbers of the result as JSON and draws them itself. What it shows over what is
chosen there; every other axis of the grid with more than one value has a slider. Drawing is our
own: libraries that could be inlined bring 1 to 5 MB, and legends and points that no key reaches.
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from markupsafe import Markup

from ..ground import UserError
from ..result import open_tree
from ..study import ALL_AXES
from ..system import make_folder, write_durably
from .in_words import SYMBOLS, unit_in_words
from .my_rubber import scaled_friction
from .template import filled_template
from .unresolved import STATUS

DIGITS = 6  # of a number on the page; errors are larger
MOST_NUMBERS = 2_000_000  # of a study, or of a comparison, about 16 MB; the longest are left out
BESIDE = ("error", "bias")  # NAME_error and NAME_bias belong to NAME
FIRST = ("relaxation_rate", "mu_1", "trace_mu", "mu")  # what is shown first, if it is there


def write_explorer(result: Path, out: Path | None = None) -> Path:
    """Write the page of a result file, by default NAME.html beside NAME.nc; return its path.

    Raises UserError where the file is no result, holds nothing that varies, is what would be
    overwritten, or the disk refuses the page.
    """
    path = out or result.with_suffix(".html")
    if path.exists() and path.samefile(result):
        raise UserError(f"--out {path}: is the result itself; name another file")
    page = explorer_page(open_tree(result), result.name)
    make_folder(path.parent)
    write_durably(path, page.encode())
    return path


def explorer_page(tree: xr.DataTree, name: str) -> str:
    """Return the page of an opened result. Raises UserError where nothing in it varies."""
    groups = {node.path.strip("/"): node.to_dataset() for node in tree.subtree}
    data = groups[""]
    held = {group: _held(dataset) for group, dataset in groups.items()}
    shown = [name for name, one in held[""].items() if one["role"] == "estimate"]
    if not shown:
        raise UserError(f"{name}: holds nothing that varies; there is nothing to explore")
    first = next((each for each in FIRST if each in shown), shown[0])
    content = {
        "axes": [_described(data[axis]) for axis in ALL_AXES if axis in data.dims],
        "groups": held,
        "first": first,
        "status": STATUS,
        "file": name,
        "rubber": scaled_friction(groups),
    }
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    return filled_template(
        "explore.html.j2",
        title=str(data.attrs["title"]),
        file=name,
        origin=f"{data.attrs['source']}, seed {data.attrs['seed']}, commit {data.attrs['commit']}",
        rubber=content["rubber"],
        data=Markup(text),
    )


def _held(dataset: xr.Dataset) -> dict[str, dict[str, Any]]:
    """Return what the page holds of a dataset: estimates, their errors, flags and abscissae."""
    found: dict[str, dict[str, Any]] = {}
    numbers = 0
    for key, variable in sorted(dataset.variables.items(), key=lambda each: each[1].size):
        name = str(key)
        long = [dim for dim in variable.dims if dim not in ALL_AXES]
        varied = any(dataset.sizes[dim] > 1 for dim in variable.dims)
        numeric = variable.dtype.kind in "fiu"
        if not numeric or not varied or len(long) > 1 or name in ALL_AXES:
            continue
        numbers += variable.size
        if numbers > MOST_NUMBERS:
            continue
        found[name] = {**_described(dataset[name]), "dims": list(variable.dims)}
        found[name]["shape"] = list(variable.shape)
        found[name]["role"] = _role(name, dataset)
    return found


def _role(name: str, dataset: xr.Dataset) -> str:
    """Return what a variable is for: shown, drawn beside what is shown, said, or an abscissa."""
    of, _, kind = name.rpartition("_")
    if kind in BESIDE and of in dataset:
        return kind
    if "flag_meanings" in dataset[name].attrs:
        return "flag"
    return "abscissa" if name in dataset.coords else "estimate"


def _described(variable: xr.DataArray) -> dict[str, Any]:
    """Return the name, meaning, unit and numbers of a variable; what is not known is None."""
    attrs = variable.attrs
    name = str(variable.name)
    told: dict[str, Any] = {
        "name": name,
        "symbol": SYMBOLS.get(name, name),
        "label": str(attrs.get("long_name", name)),
        "unit": unit_in_words(variable),
        "values": _numbers(variable.values),
    }
    if "flag_meanings" in attrs:
        words = [word.replace("_", " ") for word in str(attrs["flag_meanings"]).split()]
        values = np.atleast_1d(attrs["flag_values"]).tolist()
        told["meanings"] = dict(zip(map(str, values), words, strict=True))
    return told


def _numbers(values: np.ndarray) -> list[float | int | None]:
    """Return numbers in the order of C; those that are not finite are None."""
    if values.dtype.kind in "iu":
        return [int(value) for value in values.flat]
    return [float(f"{v:.{DIGITS}g}") if np.isfinite(v) else None for v in values.flat]
