"""The command ``law``: a reduced law of a result, said with its error and written for others."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import law  # slow to import: other commands do without
from ..ground import UserError
from ..result import check_result, open_tree, result_file
from ..study import read_study
from ..system import make_folder, write_durably
from .exit_status import DONE

if TYPE_CHECKING:
    from ..law import Law, LoadLaw

OF_A_FIT = ("states", "kind", "held_out", "group")


def run_law(options: argparse.Namespace) -> int:
    """Fit a law or read one, tell it, write it if asked to; return the exit status."""
    source, out = options.study, Path(options.out) if options.out else None
    if out and not options.write:
        raise UserError(f"--out {out}: says where to write, not what; give --write too")
    if options.write == "fmu" and not out:
        raise UserError("--write fmu: is no text; give a file by --out")
    path, found = _read(options) if source.endswith(".json") else _fitted(options)
    if out and out.exists() and out.samefile(path):
        raise UserError(f"--out {out}: is what the law is made of; name another file")
    if not options.write:
        print(*_told(found), sep="\n")
        return DONE
    written = law.export(found, options.write, (out or path).stem)
    if not out:
        print(written.content.decode(), end="")
        return DONE
    make_folder(out.parent)
    write_durably(out, written.content)
    print(*_told(found), f"{out}: {written.told}", sep="\n")
    return DONE


def _told(found: "Law | LoadLaw") -> list[str]:
    """Return a law in sentences, with its error in every motion."""
    return [*found.told(), *(f"  {rms:.3g} rms  {name}" for name, rms in found.validity.motions)]


def _read(options: argparse.Namespace) -> tuple[Path, "Law | LoadLaw"]:
    """Return a law that was written as JSON, and its file."""
    for name in OF_A_FIT:
        if getattr(options, name) is not None:
            option = name.replace("_", "-")
            raise UserError(f"--{option}: belongs to a fit, and {options.study} is a law already")
    path = Path(options.study)
    found, wanted = law.read(path), dict(map(_place, options.at or ()))
    known = ["temperature"] + ["normal_force"] * isinstance(found, law.LoadLaw)
    for axis in wanted:
        if axis not in known:
            raise UserError(f"--at {axis}: is nothing that this law depends on: {', '.join(known)}")
    return path, found.at(**wanted) if wanted else found


def _fitted(options: argparse.Namespace) -> tuple[Path, "Law | LoadLaw"]:
    """Return the law that is fitted to a result, and the file of that."""
    path = Path(options.study)
    if path.suffix != ".nc":
        study = read_study(options.study, options.scale, options.set)
        path = result_file(Path(options.results), study)
        check_result(study, path, strict=bool(options.scale or options.set))
    others = [_dataset(Path(name), None) for name in options.held_out or ()]
    given = {name: getattr(options, name) for name in ("states", "kind")}
    found = law.fit(
        _dataset(path, options.group),
        **{name: value for name, value in given.items() if value is not None},
        held_out=others or None,
        point=dict(map(_place, options.at or ())),
    )
    return path, found


def _dataset(path: Path, group: str | None) -> Any:
    """Return the dataset of a result, or of a comparison in it."""
    tree = open_tree(path)
    if group is not None and group not in tree.children:
        known = ", ".join(tree.children) or "none"
        raise UserError(f"--group {group}: {path} has no such comparison; known are {known}")
    return (tree if group is None else tree[group]).to_dataset()


def _place(text: str) -> tuple[str, float]:
    """Return axis and value of AXIS=VALUE. Raises UserError."""
    axis, _, value = text.partition("=")
    try:
        return axis, float(value)
    except ValueError:
        raise UserError(f"--at {text}: must be AXIS=VALUE, as hurst=0.7") from None
