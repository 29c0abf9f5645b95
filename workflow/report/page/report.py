"""Write the report of a folder of results: read them, judge the claims, fill the page."""

import contextlib
from pathlib import Path

from ...errors import UserError
from ...result import ROOT, open_result, result_file
from ...study import known_scales, known_studies, read_study
from ...system import write_durably
from ..claims import evaluate, known_claims
from .html import render
from .section import section


def study_names() -> list[str]:
    """Return the names of all studies, figures first."""
    return sorted(known_studies(), key=lambda name: (not name.startswith("fig"), name))


def write_report(folder: Path, names: list[str], scale: str | None = None) -> Path:
    """Write ``report.html``, or ``report-SCALE.html``, into a folder of results; return its path.

    names : studies to report on, by default all that have the scale. scale : of the results,
    which lie in files NAME-SCALE.nc; without one those of the studies as they stand, NAME.nc.
    Figures and tables are written beside the results. Raises UserError where none has a result,
    and where a named study has no such scale.
    """
    studies = [read_study(name, scale) for name in names or _names_of(scale)]
    present = [study for study in studies if result_file(folder, study).is_file()]
    if not present:
        wanted = ", ".join(study.name for study in studies)
        of, how = (f" at scale {scale}", f" SCALE={scale}") if scale else ("", "")
        raise UserError(
            f"{folder}: holds no result of {wanted}{of}; first run: make study-NAME{how}"
        )
    with contextlib.ExitStack() as stack:
        groups = {s.name: open_result(s, result_file(folder, s), stack) for s in present}
        named = {f"{n}/{g}".rstrip("/"): d for n, held in groups.items() for g, d in held.items()}
        try:
            sections = [section(s, groups[s.name], folder) for s in present]
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
        scale=scale,
        codes=sorted(codes),
    )
    path = folder / (f"report-{scale}.html" if scale else "report.html")
    write_durably(path, page.encode())
    return path


def _names_of(scale: str | None) -> list[str]:
    return [name for name in study_names() if scale is None or scale in known_scales(name)]
