"""The page of the Python interface, made of the docstrings of its public names."""

import inspect
import re
from collections.abc import Iterator
from typing import Any

import elastomer_friction as ef

# Under the name by which it is called from outside.
NAMES: dict[str, Any] = {
    "scene.run": ef.scene.run,
    "scene.animate": ef.scene.animate,
    "open": ef.open,
    "KineticLaw": ef.KineticLaw,
    "law.fit": ef.law.fit,
    "law.read": ef.law.read,
    "law.export": ef.law.export,
    "law.Law": ef.law.Law,
    "UserError": ef.UserError,
}
MEANING = re.compile(r"^\w[\w, ]* : ")  # of an argument, as our docstrings give it
WITHIN = re.compile(r"(?<=\.) (?=\w[\w, ]{0,40} : |Raises |Returns )")  # behind a full stop


def api_page() -> str:
    """Return the entries of the public names as Markdown."""
    lines: list[str] = []
    for name, public in NAMES.items():
        lines += [f"## ef.{name}\n", *_entry(name, public)]
        for method, function in _methods(public):
            lines += [f"### {name}.{method}\n", *_entry(method, function)]
    return "\n".join(lines)


def _methods(public: Any) -> Iterator[tuple[str, Any]]:
    """Yield the public methods of a class, as they stand in it."""
    if inspect.isclass(public) and public is not ef.UserError:
        for name, method in vars(public).items():
            function = getattr(method, "__func__", method)
            if inspect.isfunction(function) and not name.startswith("_") and function.__doc__:
                yield name, function


def _entry(name: str, public: Any) -> list[str]:
    """Return how a name is called, and what its docstring says."""
    told = [inspect.getdoc(public) or ""]
    made = vars(public).get("__init__") if inspect.isclass(public) else None
    if made is not None and made.__doc__:  # that of a dataclass has none
        told.append(inspect.getdoc(made) or "")
    found = [f"`{name.rpartition('.')[2]}{_arguments(public)}`\n"]
    return found + [line for text in told for line in _paragraphs(text)]


def _arguments(public: Any) -> str:
    """Return the names of the arguments, and the values of those that may be left out."""
    signature = inspect.signature(public)
    own = [
        one.replace(annotation=one.empty)
        for one in signature.parameters.values()
        if one.name not in ("self", "cls")
    ]
    plain = str(signature.replace(parameters=own, return_annotation=signature.empty))
    return re.sub(r"=<.*?>", "=...", plain)  # what is made anew at each call


def _paragraphs(text: str) -> list[str]:
    """Return a docstring as Markdown: each argument with its meaning is an item of a list."""
    found = []
    for paragraph in text.split("\n\n"):
        lines: list[str] = []
        for line in paragraph.splitlines():
            if MEANING.match(line) or not lines:
                lines.append(line.strip())
            else:
                lines[-1] += f" {line.strip()}"
        for line in (part for whole in lines for part in WITHIN.split(whole)):
            argument, colon, meaning = line.partition(" : ")
            item = MEANING.match(line) is not None
            found.append(f"- `{argument}`: {meaning.strip()}\n" if colon and item else f"{line}\n")
    return found
