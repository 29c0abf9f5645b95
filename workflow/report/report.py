"""One self-contained HTML page about all results of a folder: figures, claims, parameters."""

import base64
import contextlib
import json
import struct
from pathlib import Path
from typing import NamedTuple

import xarray as xr

from workflow.errors import UserError
from workflow.reduce import STATUS_MEANINGS
from workflow.report.claims import evaluate, known_claims
from workflow.report.drawing import STYLE
from workflow.report.figure import draw_groups
from workflow.report.page import render
from workflow.result import ROOT, Groups, differing_settings, listed, open_result, result_file
from workflow.study import AXES, AnyStudy, known_studies, read_study
from workflow.system import write_durably

SHOWN_VALUES = 6  # of an axis; of longer ones the ends
ORIGIN = {"Program": "source", "Code": "code", "Versions": "versions", "Model": "references"}
CONSTANTS = (
    ("material", "shear_modulus", "shear modulus G", "Pa"),
    ("material", "relaxation_time", "relaxation time τ", "s"),
    ("surface", "length", "length of the line L", "m"),
)


class Image(NamedTuple):
    """A figure as data URI, and its size in inches."""

    uri: str
    width: float
    height: float


def study_names() -> list[str]:
    """Return the names of all studies, figures first."""
    return sorted(known_studies(), key=lambda name: (not name.startswith("fig"), name))


def write_report(folder: Path, names: list[str], scale: str | None = None) -> Path:
    """Write ``report.html`` into a folder of results and return its path.

    names : studies to report on, all by default. scale : of the results. Raises UserError where
    none has a result, and where a study has no such scale.
    """
    studies = [read_study(name, scale) for name in names or study_names()]
    present = [study for study in studies if result_file(folder, study).is_file()]
    if not present:
        wanted = ", ".join(study.name for study in studies)
        raise UserError(f"{folder}: holds no result of {wanted}; first run: make study-NAME")
    with contextlib.ExitStack() as stack:
        groups = {s.name: open_result(s, result_file(folder, s), stack) for s in present}
        named = {f"{n}/{g}".rstrip("/"): d for n, held in groups.items() for g, d in held.items()}
        try:
            sections = [_section(s, groups[s.name], folder) for s in present]
            judges = known_claims()
            claims = evaluate(judges, named)
        except (OSError, RuntimeError) as error:  # of netCDF, which reads late
            raise UserError(f"{folder}: a result cannot be read: {error}") from error
        codes = {str(held[ROOT].attrs["code"]) for held in groups.values()}
    page = render(
        claims=claims,
        unjudged=len(judges) - len(claims),
        sections=sections,
        missing=[study for study in studies if study not in present],
        codes=sorted(codes),
    )
    path = folder / "report.html"
    write_durably(path, page.encode())
    return path


def _section(study: AnyStudy, groups: Groups, folder: Path) -> dict[str, object]:
    """Return what the page shows of one study; ``trouble`` says why there is no image."""
    data = groups[ROOT]
    image, trouble = None, ""
    try:
        image = _image(draw_groups(study, groups, result_file(folder, study))[0])
    except UserError as error:
        trouble = str(error)
    changed = differing_settings(study, data.attrs)  # from study.toml without a scale
    changes = [("Not as in study.toml", listed(changed))] if changed else []
    return {
        "name": study.name,
        "title": str(data.attrs["title"]),
        "image": image,
        "trouble": trouble,
        "parameters": _parameters(data),
        "variants": [_variant(g, held) for g, held in groups.items() if "scheme" in held.attrs],
        "facts": _facts(data) + changes,
        "origin": [(label, str(data.attrs[key])) for label, key in ORIGIN.items()],
        "settings": str(data.attrs["study"]),
    }


def _image(file: Path) -> Image:
    content = file.read_bytes()
    width, height = struct.unpack(">II", content[16:24])  # PNG: the first chunk
    uri = "data:image/png;base64," + base64.b64encode(content).decode()
    return Image(uri, width / STYLE["savefig.dpi"], height / STYLE["savefig.dpi"])


def _parameters(data: xr.Dataset) -> list[tuple[str, str, str]]:
    """Return (meaning, values, unit) of the axes, then of what is the same at all points.

    Of a measured study: its settings.
    """
    settings = json.loads(data.attrs["study"])
    if "measure" in settings:
        measured = {k: v if isinstance(v, list) else [v] for k, v in settings["measure"].items()}
        return [(k.replace("_", " "), ", ".join(map(str, v)), "") for k, v in measured.items()]
    rows = [_axis(data[axis]) for axis in AXES]
    for table, key, meaning, unit in CONSTANTS:
        rows.append((meaning, f"{settings[table][key]:g}", unit))
    return rows


def _axis(axis: xr.DataArray) -> tuple[str, str, str]:
    shown = [f"{value:.4g}" for value in axis.values]
    text = ", ".join(shown)
    if len(shown) > SHOWN_VALUES:
        text = f"{shown[0]} … {shown[-1]} ({len(shown)} values)"
    unit = str(axis.attrs["units"]).replace("s-1", "s⁻¹")
    return str(axis.attrs["long_name"]), text, "" if unit == "1" else unit


def _variant(group: str, data: xr.Dataset) -> tuple[str, str, str, str]:
    """Return name, scheme, steps per spacing and the outcome of the fits of one group."""
    fits = "no fits asked for"
    if "fit_status" in data:
        meanings = STATUS_MEANINGS.replace("no_relaxation", "nothing_to_relax").split()
        counts = {meaning: int((data.fit_status == k).sum()) for k, meaning in enumerate(meanings)}
        fits = ", ".join(f"{n} {meaning.replace('_', ' ')}" for meaning, n in counts.items() if n)
    label = group or "the study itself"
    return label, str(data.attrs["scheme"]), str(data.attrs["steps_per_spacing"]), fits


def _facts(data: xr.Dataset) -> list[tuple[str, str]]:
    attrs = {key: str(value) for key, value in data.attrs.items()}
    commit = attrs["commit"].replace("-dirty", " with changes that were not committed")
    origin = [("Seed", attrs["seed"]), ("Commit", commit)]
    if "scheme" not in attrs:  # a measured study
        return origin
    rate = "kept" if attrs["indentation_rate"] == "true" else "dropped, as eq. 3 is printed"
    return [
        ("Grid points", str(data.realizations.size)),
        ("Realizations", f"{int(data.realizations.max())} each"),
        ("Simulated", attrs["quantities"].replace(" ", ", ")),
        ("Indentation rate", rate),
        *origin,
    ]
