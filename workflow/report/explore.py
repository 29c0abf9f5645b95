"""Explorer of a result: one HTML page that needs no server and no network.

The page holds the numbers of the result as JSON and draws them itself. The reader chooses the
estimate and the abscissa; every other axis with more than one value has a slider. The page does not
use a plot library, since inlined libraries add 1 to 5 MB and cannot be operated by keyboard.
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from markupsafe import Markup

from ..ground import UserError
from ..result import body_in_words, model_in_words, open_tree
from ..study import ALL_AXES
from ..system import make_folder, write_durably
from .in_words import SYMBOLS, unit_in_words, without_tau
from .my_rubber import scaled_friction
from .template import filled_template
from .unresolved import POINT_STATUS

PAGE_DIGITS = 6  # significant digits of a number; rounding is below the standard errors
MAX_NUMBERS = 2_000_000  # per dataset, about 16 MB; the largest variables are omitted
COMPANIONS = ("error", "bias")  # NAME_error and NAME_bias accompany the estimate NAME
FIRST_ESTIMATES = ("relaxation_rate", "jump", "mu_1", "trace_mu", "mu")  # by preference


def write_explorer(result: Path, out: Path | None = None) -> Path:
    """Write the page of a result file and return its path, by default NAME.html for NAME.nc.

    Raises UserError if the file is not a result, if nothing in it varies, if the page would
    overwrite the result, or if the disk refuses the page.
    """
    path = out or result.with_suffix(".html")
    if path.exists() and path.samefile(result):
        raise UserError(f"--out {path}: is the result itself; name another file")
    page = explorer_page(open_tree(result), result.name)
    make_folder(path.parent)
    write_durably(path, page.encode())
    return path


def explorer_page(tree: xr.DataTree, name: str) -> str:
    """Return the HTML page of an opened result. Raises UserError if nothing in it varies."""
    groups = {node.path.strip("/"): node.to_dataset() for node in tree.subtree}
    data = groups[""]
    contents = {group: _page_content(without_tau(dataset)) for group, dataset in groups.items()}
    shown = [name for name, entry in contents[""].items() if entry["role"] == "estimate"]
    if not shown:
        raise UserError(f"{name}: holds nothing that varies; there is nothing to explore")
    first = next((estimate for estimate in FIRST_ESTIMATES if estimate in shown), shown[0])
    content = {
        "axes": [_described(data[axis]) for axis in ALL_AXES if axis in data.dims],
        "groups": contents,
        "first": first,
        "status": POINT_STATUS,
        "file": name,
        "rubber": scaled_friction(groups),
    }
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    return filled_template(
        "explore.html.j2",
        title=str(data.attrs["title"]),
        file=name,
        origin=f"{data.attrs['source']}, seed {data.attrs['seed']}, commit {data.attrs['commit']}. "
        f"{body_in_words(data)} {model_in_words(data)}",
        rubber=content["rubber"],
        data=Markup(text),
    )


def _page_content(dataset: xr.Dataset) -> dict[str, dict[str, Any]]:
    """Return the estimates, errors, flags and abscissae of a dataset as data for the page."""
    content: dict[str, dict[str, Any]] = {}
    numbers = 0
    for key, variable in sorted(dataset.variables.items(), key=lambda item: item[1].size):
        name = str(key)
        curve_dims = [dim for dim in variable.dims if dim not in ALL_AXES]
        varied = any(dataset.sizes[dim] > 1 for dim in variable.dims)
        numeric = variable.dtype.kind in "fiu"
        if not numeric or not varied or len(curve_dims) > 1 or name in ALL_AXES:
            continue
        numbers += variable.size
        if numbers > MAX_NUMBERS:
            continue
        content[name] = {**_described(dataset[name]), "dims": list(variable.dims)}
        content[name]["shape"] = list(variable.shape)
        content[name]["role"] = _role(name, dataset)
    return content


def _role(name: str, dataset: xr.Dataset) -> str:
    """Return the role of a variable: estimate, error, bias, flag or abscissa."""
    estimate, _, kind = name.rpartition("_")
    if kind in COMPANIONS and estimate in dataset:
        return kind
    if "flag_meanings" in dataset[name].attrs:
        return "flag"
    return "abscissa" if name in dataset.coords else "estimate"


def _described(variable: xr.DataArray) -> dict[str, Any]:
    """Return the name, symbol, meaning, unit and numbers of a variable; NaN becomes None."""
    attrs = variable.attrs
    name = str(variable.name)
    description: dict[str, Any] = {
        "name": name,
        "symbol": SYMBOLS.get(name, name),
        "label": str(attrs.get("long_name", name)),
        "unit": unit_in_words(variable),
        "values": _numbers(variable.values),
    }
    if "flag_meanings" in attrs:
        words = [word.replace("_", " ") for word in str(attrs["flag_meanings"]).split()]
        values = np.atleast_1d(attrs["flag_values"]).tolist()
        description["meanings"] = dict(zip(map(str, values), words, strict=True))
    return description


def _numbers(values: np.ndarray) -> list[float | int | None]:
    """Return numbers in C order, with non-finite numbers replaced by None."""
    if values.dtype.kind in "iu":
        return [int(value) for value in values.flat]
    return [float(f"{v:.{PAGE_DIGITS}g}") if np.isfinite(v) else None for v in values.flat]
