"""Hooks of the site: pages of the top folder become pages of it, and formulas become MathML.

Pages are written for a reader of the repository, where a link leads from docs/ up to the pages of
the top folder and from there to any file. On the site the README is the home page, the others
stand under project/, and what they name beside pages is plain text.
"""

import posixpath
import re
from functools import partial
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parents[1]
ABOVE = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")
PLACES = {name: f"project/{name.lower()}" for name in ABOVE} | {"README.md": "index.md"}
UP = re.compile(rf"\]\((?:\.\./)+({'|'.join(map(re.escape, ABOVE))})")
LINK = re.compile(r"(!?)\[([^\]]*)\]\((?!https?:|#)([^)\s]+)\)")
FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)
ESCAPED = {"&amp;": "&", "&lt;": "<", "&gt;": ">"}
VERBATIM = re.compile(r"(<(?:pre|code|math|a)\b.*?</(?:pre|code|math|a)>|<[^>]+>)", re.DOTALL)
LOWERED = re.compile(r"(?<![A-Za-z0-9_])([A-Za-z])_(N|x|b|T|c|t|max|old|new)\b")
RAISED = re.compile(r"(?<=\w)\^(\([^()]*(?:\([^()]*\)[^()]*)*\)|[\w−]+)")


def on_files(files: Files, config: Any) -> Files:
    """Add the pages of the top folder."""
    for name in ABOVE:
        text, here = (ROOT / name).read_text(encoding="utf-8"), posixpath.dirname(PLACES[name])
        content = LINK.sub(partial(_from_above, here or "."), text)
        files.append(File.generated(config, PLACES[name], content=content))
    return files


def _from_above(here: str, link: re.Match[str]) -> str:
    """Return a link of a page of the top folder, as from the folder ``here`` of the site."""
    mark, text, target = link.groups()
    name, anchor, section = target.partition("#")
    place = name.removeprefix("docs/") if name.startswith("docs/") else PLACES.get(name)
    return f"{mark}[{text}]({posixpath.relpath(place, here)}{anchor}{section})" if place else text


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Lead links that go up to the top folder to its pages on the site."""
    here = posixpath.dirname(page.file.src_uri) or "."

    def moved(link: re.Match[str]) -> str:
        return f"]({posixpath.relpath(PLACES[link[1]], here)}"

    return UP.sub(moved, markdown)


def on_page_content(html: str, **_: Any) -> str:
    """Turn formulas into MathML, which browsers draw without a script."""

    def drawn(formula: re.Match[str]) -> str:
        latex = formula[3].strip()
        for escaped, plain in ESCAPED.items():
            latex = latex.replace(escaped, plain)
        return convert(latex, display="block" if formula[2] == "[" else "inline")

    parts = VERBATIM.split(FORMULA.sub(drawn, html))
    parts[::2] = [_with_indices(text) for text in parts[::2]]
    return "".join(parts)


def _with_indices(text: str) -> str:
    """Return plain text with F_N and q^(1−H) as a lowered and a raised index."""
    text = LOWERED.sub(r"\1<sub>\2</sub>", text)
    return RAISED.sub(lambda found: f"<sup>{found[1].strip('()')}</sup>", text)
