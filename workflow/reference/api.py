"""Reference page of the Python interface, generated from docstrings."""

import inspect
import re
from collections.abc import Iterator
from typing import Any

import elastomer_friction as ef

# name that a caller uses -> object
PUBLIC_MODULES: dict[str, Any] = {
    "scene.run": ef.scene.run,
    "scene.animate": ef.scene.animate,
    "plan": ef.plan,
    "run": ef.run,
    "figure": ef.figure,
    "open": ef.open,
    "block_means": ef.block_means,
    "prony": ef.prony,
    "KineticLaw": ef.KineticLaw,
    "law.fit": ef.law.fit,
    "law.read": ef.law.read,
    "law.export": ef.law.export,
    "law.Law": ef.law.Law,
    "UserError": ef.UserError,
}
MEANING = re.compile(r"^\w[\w, ]* : ")  # start of an argument's line in a docstring
# space between two sentences at which a line is split
SPLIT = re.compile(r"(?<=\.) (?=\w[\w, ]{0,40} : |Raises |Returns )")


def api_page() -> str:
    """Return the entries of the public names as Markdown."""
    lines: list[str] = []
    for name, public in PUBLIC_MODULES.items():
        lines += [f"## ef.{name}\n", *_entry(name, public)]
        for method, function in _methods(public):
            lines += [f"### {name}.{method}\n", *_entry(method, function)]
    return "\n".join(lines)


def _methods(public: Any) -> Iterator[tuple[str, Any]]:
    """Yield the public methods of a class, in the order of its source."""
    if inspect.isclass(public) and public is not ef.UserError:
        for name, method in vars(public).items():
            function = getattr(method, "__func__", method)
            if inspect.isfunction(function) and not name.startswith("_") and function.__doc__:
                yield name, function


def _entry(name: str, public: Any) -> list[str]:
    """Return the call of a public name, and its docstring as Markdown."""
    docstrings = [inspect.getdoc(public) or ""]
    constructor = vars(public).get("__init__") if inspect.isclass(public) else None
    if constructor is not None and constructor.__doc__:  # a dataclass has no docstring there
        docstrings.append(inspect.getdoc(constructor) or "")
    call = f"`{name.rpartition('.')[2]}{_arguments(public)}`\n"
    return [call, *(line for text in docstrings for line in _paragraphs(text))]


def _arguments(public: Any) -> str:
    """Return the arguments with their defaults, without annotations."""
    signature = inspect.signature(public)
    parameters = [
        parameter.replace(annotation=parameter.empty)
        for parameter in signature.parameters.values()
        if parameter.name not in ("self", "cls")
    ]
    text = str(signature.replace(parameters=parameters, return_annotation=signature.empty))
    return re.sub(r"=<.*?>", "=...", text)  # defaults that are not literals, such as factories


def _paragraphs(text: str) -> list[str]:
    """Return a docstring as Markdown, with arguments as items of a list."""
    markdown = []
    for paragraph in text.split("\n\n"):
        lines: list[str] = []
        for line in paragraph.splitlines():
            if MEANING.match(line) or not lines:
                lines.append(line.strip())
            else:
                lines[-1] += f" {line.strip()}"
        for line in (part for whole in lines for part in SPLIT.split(whole)):
            argument, colon, meaning = line.partition(" : ")
            is_item = colon and MEANING.match(line)
            markdown.append(f"- `{argument}`: {meaning.strip()}\n" if is_item else f"{line}\n")
    return markdown
