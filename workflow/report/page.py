"""Report on a folder of results: one HTML page with the judged claims and a section per study.

A section has the figures, files, parameters and origin of a study. Formulas in plain text are
typeset as HTML.
"""

import base64
import contextlib
import json
import re
import struct
from pathlib import Path

import numpy as np
import xarray as xr
from markupsafe import Markup, escape

from ..ground import UserError
from ..reduce import STATUS_MEANINGS
from ..result import (
    ROOT,
    Groups,
    change_note,
    differing_settings,
    listed,
    model_in_words,
    open_result,
    result_file,
)
from ..study import AnyStudy, known_scales, known_studies, read_study
from ..system import program, write_durably
from .claims import evaluate, known_claims
from .csv_tables import write_tables
from .explore import write_explorer
from .figure import Picture, draw_groups
from .in_words import unit_in_words
from .panels import STYLE
from .template import filled_template

NO_BREAK = "\u00a0"
UNCONDITIONAL = re.compile(r"holds( within (a factor )?[\d.]+( %)?)?")
SMOKE = "smoke"
MAX_LISTED_VALUES = 6  # of an axis; for a longer axis only the first and last value are shown
ORIGIN = {"Program": "source", "Code": "code", "Versions": "versions", "Model": "references"}
CONSTANTS = ("shear_modulus", "tau", "length")  # listed coordinates that are not axes


def study_names() -> list[str]:
    """Return the names of all studies; names that begin with "fig" come first."""
    return sorted(known_studies(), key=lambda name: (not name.startswith("fig"), name))


def write_report(folder: Path, names: list[str], scale: str | None = None) -> Path:
    """Write ``report.html``, or ``report-SCALE.html``, into a folder of results; return its path.

    names : studies of the report; empty: all studies that have the scale. scale : scale of the
    results, read from NAME-SCALE.nc; None: the default scale, read from NAME.nc. Figures and tables
    are written to the same folder. Raises UserError if no study has a result, or if a named study
    lacks the scale.
    """
    named = bool(names)
    if not named:
        names = [name for name in study_names() if scale is None or scale in known_scales(name)]
    studies = [read_study(name, scale) for name in names]
    present = [study for study in studies if result_file(folder, study).is_file()]
    if not present:
        wanted = ", ".join(study.name for study in studies)
        at_scale = f" at scale {scale}" if scale else ""
        command = how_to_run("NAME", scale)
        raise UserError(f"{folder}: holds no result of {wanted}{at_scale}; first run: {command}")
    of_paper = any((study.folder / "claims.py").is_file() for study in present)
    absent = [study for study in studies if study not in present] if of_paper or named else []
    page = filled_template(
        "report.html.j2",
        formula,
        verdict_class,
        of_paper=of_paper,
        missing=[(how_to_run(study.name, scale), study.title) for study in absent],
        again=f"{program()} report{f' --scale {scale}' if scale else ''}",
        **_sections_and_claims(folder, present),
    )
    path = folder / (f"report-{scale}.html" if scale else "report.html")
    write_durably(path, page.encode())
    return path


def _sections_and_claims(folder: Path, studies: list[AnyStudy]) -> dict[str, object]:
    """Return the sections, judged claims, number of unjudged claims and versions of the code."""
    with contextlib.ExitStack() as stack:
        groups = {s.name: open_result(s, result_file(folder, s), stack) for s in studies}
        datasets = {
            f"{name}/{label}".rstrip("/"): dataset
            for name, study_groups in groups.items()
            for label, dataset in study_groups.items()
        }
        judges = known_claims()
        try:
            sections = [section(s, groups[s.name], folder) for s in studies]
            claims = evaluate(judges, datasets)
        except (OSError, RuntimeError) as error:  # raised late, since netCDF reads lazily
            raise UserError(f"{folder}: a result cannot be read: {error}") from error
        codes = sorted({str(study_groups[ROOT].attrs["code"]) for study_groups in groups.values()})
    unjudged = len(judges) - len(claims)
    return {"sections": sections, "claims": claims, "unjudged": unjudged, "codes": codes}


def how_to_run(name: str, scale: str | None) -> str:
    """Return the command that computes a study: ``make`` in a checkout, else the program."""
    if Path("Makefile").is_file() and Path("studies").is_dir():
        return f"make study-{name}{f' SCALE={scale}' if scale else ''}"
    return f"{program()} run {name}{f' --scale {scale}' if scale else ''}"


def verdict_class(verdict: str) -> str:
    """Return the CSS class of a verdict; it is "only" for a conditional or partial "holds"."""
    first = verdict.split()[0]
    return "only" if first == "holds" and not UNCONDITIONAL.fullmatch(verdict) else first


def formula(text: str) -> Markup:
    """Return plain text as HTML with x_N, x^(1−H) and 1e-06 typeset; "H = 0.3" does not break."""
    text = re.sub(r"(\d)e([+-]\d+)", lambda power: f"{power[1]}·10^({int(power[2])})", text)
    text = re.sub(r" [=<>±∝] | %", lambda sign: sign[0].replace(" ", NO_BREAK), text)
    text = re.sub(r"(?<!\w)-(?=\d)", "−", text)
    raised = re.sub(r"\^(?:\(([^)]*)\)|([−\d.]+|\w))", r"<sup>\1\2</sup>", str(escape(text)))
    return Markup(re.sub(r"_(max|[Nc]\b)", r"<sub>\1</sub>", raised))


def section(study: AnyStudy, groups: Groups, folder: Path) -> dict[str, object]:
    """Return the fields of a study's section; ``troubles`` explain a missing figure or table.

    Figures, tables and the explorer are written to the folder of the result.
    """
    data, result = groups[ROOT], result_file(folder, study)
    troubles = [f"{result.name} {note}"] if (note := change_note(result)) else []
    pictures: list[Picture] = []
    tables: list[Path] = []
    try:
        pictures = draw_groups(study, groups, result)
    except UserError as error:
        troubles.append(f"No figure: {error}")
    try:
        tables = write_tables(study, groups, result)
    except UserError as error:
        troubles.append(f"No table: {error}")
    explorer = ""
    with contextlib.suppress(UserError):  # raised if nothing in the result varies
        explorer = write_explorer(result).name
    changed = differing_settings(study, data.attrs)
    scale = _scale(study, data.attrs)
    return {
        "name": study.name,
        "title": str(data.attrs["title"]),
        "smoke": scale.startswith(SMOKE),
        "extent": f"{scale}{_realizations(data)}",
        "images": [_image(picture) for picture in pictures],
        "files": [file.name for file in (result, *(picture.pdf for picture in pictures), *tables)],
        "explorer": explorer,
        "troubles": troubles,
        "parameters": _parameters(study, data),
        "variants": [_variant(g, d) for g, d in groups.items() if "scheme" in d.attrs],
        "facts": _facts(data) + ([("Not as in study.toml", listed(changed))] if changed else []),
        "origin": [(label, str(data.attrs[key])) for label, key in ORIGIN.items()],
        "settings": str(data.attrs["study"]),
    }


def _realizations(data: xr.Dataset) -> str:
    """Return the range of the numbers of realizations as text, or "" without realizations."""
    counts = np.unique(data.realizations) if "realizations" in data else np.zeros(1)
    ends = " to ".join(dict.fromkeys(f"{int(count)}" for count in (counts[0], counts[-1])))
    return f", {ends} realizations" if counts[-1] else ""


def _scale(study: AnyStudy, attributes: dict[str, object]) -> str:
    """Return the scale of a result as text, from its settings rather than its file name."""
    for scale in dict.fromkeys([study.scale, "", *known_scales(study.name)]):
        if not differing_settings(read_study(study.name, scale or None), attributes):
            return f"{scale or 'default'} scale"
    return f"{study.scale or 'default'} scale with other settings"


def _image(picture: Picture) -> dict[str, object]:
    """Return a figure as data URI, with its size in inches, hover points and caption."""
    content = picture.png.read_bytes()
    width, height = struct.unpack(">II", content[16:24])  # pixels, from the first chunk of the PNG
    uri = "data:image/png;base64," + base64.b64encode(content).decode()
    inches = {"width": width / STYLE["savefig.dpi"], "height": height / STYLE["savefig.dpi"]}
    return {"uri": uri, **inches, "points": picture.points, "caption": picture.caption}


def _parameters(study: AnyStudy, data: xr.Dataset) -> list[tuple[str, str, str]]:
    """Return (meaning, values, unit) of the axes with known values, and of CONSTANTS.

    For a measured study, return its settings in this form.
    """
    settings = json.loads(data.attrs["study"])
    if "measure" in settings:
        measured = {k: v if isinstance(v, list) else [v] for k, v in settings["measure"].items()}
        return [(k.replace("_", " "), ", ".join(map(str, v)), "") for k, v in measured.items()]
    names = [*(axis for axis in data.dims if axis in study.axes), *CONSTANTS]
    return [_axis(data[name]) for name in names if data[name].notnull().any()]


def _axis(axis: xr.DataArray) -> tuple[str, str, str]:
    values = [f"{value:.4g}" for value in axis.values.flat]
    text = ", ".join(values)
    if len(values) > MAX_LISTED_VALUES:
        text = f"{values[0]} … {values[-1]} ({len(values)} values)"
    return str(axis.attrs["long_name"]), text, unit_in_words(axis)


def _variant(group: str, data: xr.Dataset) -> tuple[str, str, str, str]:
    """Return the name, scheme, steps per spacing and fit outcomes of one group."""
    fits = "no fits requested"
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
    model = [("Error of the model", text)] if (text := model_in_words(data)) else []
    rate = "kept" if attrs["indentation_rate"] == "true" else "dropped, as eq. 3 is printed"
    return [
        ("Grid points", str(data.realizations.size)),
        ("Realizations", f"{int(data.realizations.max())} each"),
        ("Simulated", attrs["quantities"].replace(" ", ", ")),
        ("Indentation rate", rate),
        *model,
        *origin,
    ]
