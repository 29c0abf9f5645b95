"""Export of a reduced law: a C99 header, Fortran, a co-simulation FMU, or JSON.

The C and Fortran files are rendered from the templates in this folder, which implement the step of
memory_law.py. FMI: Functional Mock-up Interface 2.0.4, Modelica Association, 2022.
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

from ..given_motion import MAX_PARTS, ROUNDING, LawError
from ..ground import printable
from ..system import VERSION
from .load_law import LOAD_TABLES, LoadLaw
from .memory_law import MemoryLaw
from .reduced_law import Law
from .transients import MAX_VELOCITY_CHANGE

COMMENT_WIDTH = 92
LARGEST_BOUND = 1e300  # in place of infinity
FMU_TIMESTAMP = (1980, 1, 1, 0, 0, 0)  # fixed, so that the same law gives the same bytes
COMPILERS = ("cc", "gcc", "clang")
COMPILER_FLAGS = ("-std=c99", "-O2", "-fPIC", "-shared", "-ffp-contract=off")
FMI_FOLDERS = {"x86_64": "linux64", "i686": "linux32"}  # machine -> folder of FMI 2.0
TEMPLATES = {  # form -> template, description
    "c": ("law.h.j2", "a header in C99"),
    "fortran": ("law.f.j2", "Fortran: VFRIC_COEF for Abaqus/Explicit, and a step with states"),
}
FORMS = (*TEMPLATES, "fmu", "json")


class Exported(NamedTuple):
    """Content of an exported file, and its description."""

    content: bytes
    description: str


def export_law(law: Law | LoadLaw, form: str, name: str = "friction_law") -> Exported:
    """Return a law in one of the forms c, fortran, fmu and json.

    name : prefix of the functions and name of the model. Every law can be written as json; the
    other forms require a law of the kind "states" or a table of such laws over the load. C takes
    the load in the init function, the FMU as a parameter; Fortran takes the law of one load. The
    FMU contains C sources and, on x86 Linux with a C compiler, a compiled library. Raises UserError
    for an unknown form and for a law that the form does not support.
    """
    if form not in FORMS:
        raise LawError(f"{form}: unknown form of a law; must be one of {', '.join(FORMS)}")
    if form == "json":
        return Exported(law.to_json().encode() + b"\n", "the law as JSON")
    if not isinstance(law, MemoryLaw | LoadLaw):
        raise LawError(f"{form}: requires a law of the kind states, not {law.kind}; write json")
    if form == "fortran" and isinstance(law, LoadLaw):
        raise LawError("fortran: requires the law of one load; use law.at(normal_force=...)")
    name = re.sub(r"\W+", "_", re.sub(r"^(?=\d)|^$", "_", name), flags=re.ASCII)
    if form == "fmu":
        return _fmu(law, name)
    template, description = TEMPLATES[form]
    return Exported(_rendered(template, law, name), description)


def _rendered(template: str, law: MemoryLaw | LoadLaw, name: str, guid: str = "") -> bytes:
    """Return a template rendered for a law, in UTF-8."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    loader = PackageLoader(__package__, ".")
    environment = Environment(
        loader=loader, undefined=StrictUndefined, trim_blocks=True, keep_trailing_newline=True
    )
    environment.filters["bound"] = lambda value, unknown: (
        min(value, LARGEST_BOUND) if value > 0.0 else unknown
    )
    environment.filters["number"] = lambda value: repr(float(value))
    environment.filters["fortran"] = lambda value: f"{float(value):.17e}".replace("e", "d")
    environment.filters["numbers"] = lambda row: ", ".join(repr(float(value)) for value in row)
    over_load = isinstance(law, LoadLaw)
    tables = {table: np.array(getattr(law, table)) for table in LOAD_TABLES}
    if not over_load:
        tables = {table: values[None] for table, values in tables.items()}
    tables["per_length"] = tables.pop("rate_per_length").T
    tables["rate"] = tables["rate"].T
    tables["target"] = np.swapaxes(tables["target"], 0, 1)
    text = environment.get_template(template).render(
        law=law,
        name=name,
        upper=name.upper(),
        version=VERSION,
        piece=MAX_VELOCITY_CHANGE,
        rounding=ROUNDING,
        max_parts=MAX_PARTS,
        descriptions=law.memories(),
        summary=_summary(law, name),
        comments=_comments(law),
        guid=guid,
        over_load=over_load,
        **tables,  # axes: memories, loads, speeds
        memories=len(tables["rate"]),
        mean_load=float(np.sqrt(law.load[0] * law.load[-1])) if isinstance(law, LoadLaw) else 0.0,
    )
    return text.encode()


def _summary(law: MemoryLaw | LoadLaw, name: str) -> str:
    """Return the source, range, error and body of a law; the header of the sources has the rest."""
    validity = law.validity
    facts = (f"fitted to {validity.source}", law.range_text(), law.error_text(), validity.body)
    return "; ".join([*filter(None, facts), f"details: sources/{name}.h"])


def _comments(law: MemoryLaw | LoadLaw) -> list[str]:
    """Return the comment lines on source, range and errors, wrapped at COMMENT_WIDTH."""
    segments = [f"rms error {rms:.2g} in {segment}" for segment, rms in law.validity.motions]
    return [
        line.replace("*/", "* /")
        for text in (f"fitted to {law.validity.source}", *law.told()[1:], *segments)
        for line in textwrap.wrap(printable(text), COMMENT_WIDTH)
    ]


def _fmu(law: MemoryLaw | LoadLaw, name: str) -> Exported:
    """Return the FMU of a law, with a library for this machine if it can be compiled."""
    header = _rendered("law.h.j2", law, name)
    guid = "{" + hashlib.sha256(header).hexdigest()[:32] + "}"
    files = {
        "modelDescription.xml": _rendered("modelDescription.xml.j2", law, name, guid),
        f"sources/{name}.h": header,
        "sources/fmu.c": _rendered("fmu.c.j2", law, name, guid),
    }
    compiler = next(filter(None, map(shutil.which, COMPILERS)), None)
    folder = FMI_FOLDERS.get(platform.machine()) if platform.system() == "Linux" else None
    description = "an FMU with C sources alone: this machine has no suitable C compiler"
    if compiler and folder:
        files[f"binaries/{folder}/{name}.so"] = _library(compiler, files)
        description = f"an FMU with its C sources and a library for {folder}"
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as fmu:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, FMU_TIMESTAMP)
            entry.external_attr = 0o644 << 16
            fmu.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return Exported(archive.getvalue(), description)


def _library(compiler: str, files: dict[str, bytes]) -> bytes:
    """Return the shared library of the sources of an FMU. Raises UserError if compiling fails."""
    with tempfile.TemporaryDirectory() as folder:
        for path, content in files.items():
            (Path(folder) / Path(path).name).write_bytes(content)
        command = [compiler, *COMPILER_FLAGS, "fmu.c", "-o", "law.so", "-lm"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode:
            raise LawError(f"fmu: {compiler} failed: {done.stderr.strip().splitlines()[-1:]}")
        return (Path(folder) / "law.so").read_bytes()
