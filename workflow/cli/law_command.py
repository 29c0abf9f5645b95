"""The command ``law``: fit or read a reduced law, then describe or export it."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import law  # slow to import, which other commands avoid
from ..ground import UserError
from ..result import check_result, open_tree, result_file
from ..study import read_study
from ..system import make_folder, write_durably

if TYPE_CHECKING:
    from ..law import Law, LoadLaw

FIT_OPTIONS = ("states", "kind", "held_out", "group")


def run_law(options: argparse.Namespace) -> None:
    """Fit or read a law, describe it, and write it if requested."""
    source, out = options.study, Path(options.out) if options.out else None
    if out and not options.write:
        raise UserError(f"--out {out}: requires a form; add --write, for example --write json")
    if options.write == "fmu" and not out:
        raise UserError("--write fmu: is a binary file; give its path by --out")
    path, reduced_law = _read(options) if source.endswith(".json") else _fitted(options)
    if out and out.exists() and out.samefile(path):
        raise UserError(f"--out {out}: is the input of the law; choose another file")
    if not options.write:
        errors = [f"  {rms:.2g} rms  {motion}" for motion, rms in reduced_law.validity.motions]
        print(*reduced_law.told(), *errors, sep="\n")
        return
    exported = law.export(reduced_law, options.write, (out or path).stem)
    if not out:
        print(exported.content.decode(), end="")
        return
    make_folder(out.parent)
    write_durably(out, exported.content)
    print(*reduced_law.told(), f"{out}: {exported.description}", sep="\n")


def _read(options: argparse.Namespace) -> tuple[Path, "Law | LoadLaw"]:
    """Return the path of a JSON file and its law, taken at the point ``--at`` if given."""
    for name in FIT_OPTIONS:
        if getattr(options, name) is not None:
            option = name.replace("_", "-")
            raise UserError(f"--{option}: applies to a fit, but {options.study} is a law; omit it")
    path = Path(options.study)
    reduced_law, point = law.read(path), dict(map(_axis_value, options.at or ()))
    axes = ["temperature"] + ["normal_force"] * isinstance(reduced_law, law.LoadLaw)
    for axis in point:
        if axis not in axes:
            raise UserError(f"--at {axis}: must be an axis of this law: {', '.join(axes)}")
    return path, reduced_law.at(**point) if point else reduced_law


def _fitted(options: argparse.Namespace) -> tuple[Path, "Law | LoadLaw"]:
    """Return the path of a result file and the law fitted to it."""
    path = Path(options.study)
    if path.suffix != ".nc":
        study = read_study(options.study, options.scale, options.set)
        path = result_file(Path(options.results), study)
        check_result(study, path, strict=bool(options.scale or options.set))
    held_out = [_dataset(Path(name), None) for name in options.held_out or ()]
    settings = {name: getattr(options, name) for name in ("states", "kind")}
    reduced_law = law.fit(
        _dataset(path, options.group),
        **{name: value for name, value in settings.items() if value is not None},
        held_out=held_out or None,
        point=dict(map(_axis_value, options.at or ())),
    )
    return path, reduced_law


def _dataset(path: Path, group: str | None) -> Any:
    """Return the dataset of a result file, or of the comparison ``group`` in it."""
    tree = open_tree(path)
    if group is not None and group not in tree.children:
        groups = ", ".join(tree.children) or "none"
        raise UserError(f"--group {group}: is not a comparison in {path}; must be one of {groups}")
    return (tree if group is None else tree[group]).to_dataset()


def _axis_value(text: str) -> tuple[str, float]:
    """Parse AXIS=VALUE. Raises UserError for other text."""
    axis, _, value = text.partition("=")
    try:
        return axis, float(value)
    except ValueError:
        raise UserError(f"--at {text}: must be AXIS=VALUE, for example hurst=0.7") from None
