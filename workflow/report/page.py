"""The report as HTML: fills the template, and sets formulas written as plain text."""

import re
from importlib.resources import files

from jinja2 import Environment, StrictUndefined
from markupsafe import Markup, escape

NO_BREAK = "\u00a0"


def render(**context: object) -> str:
    """Return the page; every text in it is escaped."""
    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["formula"] = formula
    text = files("workflow.report").joinpath("report.html.j2").read_text(encoding="utf-8")
    return environment.from_string(text).render(**context)


def formula(text: str) -> Markup:
    """Return plain text as HTML: x_N, x^(1−H) and 1e-06 set, no break inside "H = 0.3"."""
    text = re.sub(r"(\d)e([+-]\d+)", lambda power: f"{power[1]}·10^({int(power[2])})", text)
    text = re.sub(r" [=<>±∝] | %", lambda sign: sign[0].replace(" ", NO_BREAK), text)
    text = re.sub(r"(?<!\w)-(?=\d)", "−", text)
    raised = re.sub(r"\^(?:\(([^)]*)\)|([−\d.]+|\w))", r"<sup>\1\2</sup>", str(escape(text)))
    return Markup(re.sub(r"_(max|[Nc]\b)", r"<sub>\1</sub>", raised))
