"""The report as HTML: fills the template, and sets formulas written as plain text."""

import re

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

NO_BREAK = "\u00a0"
PLAIN = re.compile(r"holds( within (a factor )?[\d.]+( %)?)?")  # everywhere, without a condition


def render(**context: object) -> str:
    """Return the page; every text in it is escaped."""
    loader = PackageLoader("elastomer_friction.workflow.report", "page")
    environment = Environment(
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        loader=loader,
    )
    environment.filters["formula"] = formula
    environment.filters["verdict_class"] = verdict_class
    return environment.get_template("report.html.j2").render(**context)


def verdict_class(verdict: str) -> str:
    """Return the colour of a verdict: what holds on a condition, or in part, is as "only" is."""
    first = verdict.split()[0]
    return "only" if first == "holds" and not PLAIN.fullmatch(verdict) else first


def formula(text: str) -> Markup:
    """Return plain text as HTML: x_N, x^(1−H) and 1e-06 set, no break inside "H = 0.3"."""
    text = re.sub(r"(\d)e([+-]\d+)", lambda power: f"{power[1]}·10^({int(power[2])})", text)
    text = re.sub(r" [=<>±∝] | %", lambda sign: sign[0].replace(" ", NO_BREAK), text)
    text = re.sub(r"(?<!\w)-(?=\d)", "−", text)
    raised = re.sub(r"\^(?:\(([^)]*)\)|([−\d.]+|\w))", r"<sup>\1\2</sup>", str(escape(text)))
    return Markup(re.sub(r"_(max|[Nc]\b)", r"<sub>\1</sub>", raised))
