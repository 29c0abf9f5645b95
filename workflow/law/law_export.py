"""A law for other programs: C99, a table of Abaqus, Modelica, Fortran, a co-simulation FMU, JSON.

What is written is made from the templates beside this file, which state the step of memory_law.py
in the words of each. FMI: Functional Mock-up Interface 2.0.4, Modelica Association, 2022.
"""

import hashlib
import io
import platform
import re
import shutil
import subprocess
import tempfile
import textwrap
import zipfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..given_motion import LawError
from ..ground import printable
from ..system import VERSION
from .load_law import NUMBERS, LoadLaw
from .memory_law import MemoryLaw
from .reduced_law import Law

WIDTH = 92  # of comments
BETWEEN = 4  # rows of a table of Abaqus for each of ours
EPOCH = (1980, 1, 1, 0, 0, 0)  # of the files of an FMU: one law gives the same bytes
COMPILERS = ("cc", "gcc", "clang")
FLAGS = ("-std=c99", "-O2", "-fPIC", "-shared", "-ffp-contract=off")
TEXTS = {  # template, and what is made of it
    "c": ("law.h.j2", "a header in C99"),
    "abaqus": ("law.inp.j2", "a table of *FRICTION for Abaqus: steady friction alone"),
    "modelica": ("law.mo.j2", "a block of Modelica"),
    "fortran": ("law.f.j2", "Fortran: VFRIC_COEF for Abaqus/Explicit, and a step with states"),
}
FORMS = (*TEXTS, "fmu", "json")
LINUX = {"x86_64": "linux64", "i686": "linux32"}  # machine -> folder of FMI 2.0


class Exported(NamedTuple):
    """A law as a file, and what is to be said of it."""

    content: bytes
    told: str


def export_law(law: Law | LoadLaw, form: str, name: str = "friction_law") -> Exported:
    """Return a law in one of FORMS: c, abaqus, modelica, fortran, fmu, json.

    name : from which the names of functions, block and model are made. All but json are of a law
    of states, or of a table of them over the load: C takes the load with the first state, Modelica
    and the FMU as a parameter, and Fortran is of one. An FMU holds a library for this machine
    where there is a C compiler, else its sources alone. Raises UserError for another form or law.
    """
    if form not in FORMS:
        raise LawError(f"{form}: no form of a law; known are {', '.join(FORMS)}")
    if form == "json":
        return Exported(law.to_json().encode() + b"\n", "the law as JSON")
    if not isinstance(law, MemoryLaw | LoadLaw):
        raise LawError(f"{form}: takes laws of the kind states, not {law.kind}; write json")
    if form == "fortran" and isinstance(law, LoadLaw):
        raise LawError("fortran: takes the law of one load; give law.at(normal_force=...)")
    name = re.sub(r"\W+", "_", re.sub(r"^(?=\d)|^$", "_", name), flags=re.ASCII)
    if form == "fmu":
        return _fmu(law, name)
    template, told = TEXTS[form]
    return Exported(_rendered(template, law, name), told)


def _rendered(template: str, law: MemoryLaw | LoadLaw, name: str, guid: str = "") -> bytes:
    """Return a template filled in."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    loader = PackageLoader(__package__, ".")
    filled = Environment(
        loader=loader, undefined=StrictUndefined, trim_blocks=True, keep_trailing_newline=True
    )
    filled.filters["number"] = lambda value: repr(float(value))
    filled.filters["fortran"] = lambda value: f"{float(value):.17e}".replace("e", "d")
    filled.filters["numbers"] = lambda row: ", ".join(repr(float(value)) for value in row)
    source = f"fitted to {law.validity.source}"
    per_motion = [f"rms error {rms:.3g} in {where}" for where, rms in law.validity.motions]
    told = [
        line.replace("*/", "* /")
        for each in (source, *law.told()[1:], *per_motion)
        for line in textwrap.wrap(printable(each), WIDTH)
    ]
    filled.filters["transposed"] = lambda rows: np.transpose(rows)
    filled.filters["columns"] = lambda row: ", ".join(f"{value:.8g}" for value in row)
    over = isinstance(law, LoadLaw)
    tables = {each: np.array(getattr(law, each)) for each in NUMBERS}
    if not over:
        tables = {each: table[None] for each, table in tables.items()}
    tables["per_length"] = tables.pop("rate_per_length").T
    tables["rate"] = tables["rate"].T
    tables["target"] = np.swapaxes(tables["target"], 0, 1)
    text = filled.get_template(template).render(
        law=law,
        name=name,
        upper=name.upper(),
        version=VERSION,
        told=told,
        guid=guid,
        over=over,
        **tables,  # over memories, loads and speeds
        memories=len(tables["rate"]),
        middle=float(np.sqrt(law.load[0] * law.load[-1])) if isinstance(law, LoadLaw) else np.nan,
        rows=_rows(law),
        lost=law.validity.usual * float(np.sqrt(law.validity.left)),
    )
    return text.encode()


def _rows(law: MemoryLaw | LoadLaw) -> list[tuple[float, ...]]:
    """Return steady friction, the slip rate and, of a table over the load, the normal force."""
    if isinstance(law, LoadLaw):
        return [(*row, f) for f in law.load for row in _rows(law.at(normal_force=float(f)))]
    corners = np.concatenate([[0.0], law.speed])
    at = np.interp(np.arange(0, corners.size - 0.99, 1 / BETWEEN), range(corners.size), corners)
    return list(zip(law.steady(at), at, strict=True))


def _fmu(law: MemoryLaw | LoadLaw, name: str) -> Exported:
    header = _rendered("law.h.j2", law, name)
    guid = "{" + hashlib.sha256(header).hexdigest()[:32] + "}"
    files = {
        "modelDescription.xml": _rendered("modelDescription.xml.j2", law, name, guid),
        f"sources/{name}.h": header,
        "sources/fmu.c": _rendered("fmu.c.j2", law, name, guid),
    }
    compiler = next(filter(None, map(shutil.which, COMPILERS)), None)
    folder = LINUX.get(platform.machine()) if platform.system() == "Linux" else None
    told = "an FMU of its C sources alone: there is no C compiler for it on this machine"
    if compiler and folder:
        files[f"binaries/{folder}/{name}.so"] = _library(compiler, files)
        told = f"an FMU with its C sources and a library for {folder}"
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as whole:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, EPOCH)
            entry.external_attr = 0o644 << 16
            whole.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return Exported(packed.getvalue(), told)


def _library(compiler: str, files: dict[str, bytes]) -> bytes:
    """Return the shared library of the sources of an FMU. Raises UserError where none is made."""
    with tempfile.TemporaryDirectory() as folder:
        for path, content in files.items():
            (Path(folder) / Path(path).name).write_bytes(content)
        command = [compiler, *FLAGS, "fmu.c", "-o", "law.so", "-lm"]
        made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if made.returncode:
            raise LawError(f"fmu: {compiler} says: {made.stderr.strip().splitlines()[-1:]}")
        return (Path(folder) / "law.so").read_bytes()
