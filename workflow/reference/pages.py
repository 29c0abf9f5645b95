"""The pages of reference: which there are, how they are written, and the index and commands.

The index names every key, variable and quantity in the order of the alphabet; the page of commands
is made of the parsers of the command line.
"""

import argparse
import re
from collections.abc import Callable
from pathlib import Path

from ..cli import command_parser
from ..result import described_variables
from ..study import EVERY_TABLE, QUANTITIES, described_measures
from .keys import keys_page
from .results import results_page

INDEX_HEAD = """# Index

Every key of `study.toml`, every variable of a result and every quantity, in the order of the
alphabet. Symbols and terms are in the [glossary](../glossary.md), commands on
[their page](commands.md).

| name | what it is |
|---|---|"""
COMMANDS_HEAD = """# Every command

The command line is `elastomer-friction COMMAND`. Every command answers `--help`. A command that is
given wrong input prints one line that names it, and changes nothing. The exit status is 0 when a
command is done, 2 for wrong input or surroundings, 3 when it is done but for problems that failed
or when `verify` finds a fault, and 130 when it was interrupted. A run that was interrupted goes on
where it ended when it is started again.
"""
NOTE = "<!-- Written by `make docs` from the tables in the code; change the texts there. -->\n\n"


def index_page() -> str:
    """Return the page of the index as Markdown."""
    rows = {}
    places = {table: (f"key of `[{table}]`", keys) for table, keys in EVERY_TABLE.items()}
    for study, keys in described_measures().items():
        places[f"{study}: measure"] = (f"key of `[measure]` of the study `{study}`", keys)
    for table, (where, keys) in places.items():
        for key in keys:
            heading = f"{table}.{key}"
            rows[key, where] = f"[`{key}`](keys.md#{anchor(heading)}) | {where}"
    for section in described_variables().values():
        for variable in section:
            said = f"variable: {variable.long_name}"
            link = f"results.md#{anchor(variable.name)}"
            rows[variable.name, said] = f"[`{variable.name}`]({link}) | {said}"
    for name, quantity in QUANTITIES.items():
        said = f"quantity: {quantity.effect}"
        rows[name, said] = f"[`{name}`](keys.md#quantities) | {said}"
    return "\n".join([INDEX_HEAD, *(f"| {rows[name]} |" for name in sorted(rows))])


def anchor(heading: str) -> str:
    """Return the name by which pages link to a heading."""
    return re.sub(r"[^\w\- ]", "", heading).strip().lower().replace(" ", "-")


def commands_page() -> str:
    """Return the page of commands as Markdown."""
    parser = command_parser()
    lines = [COMMANDS_HEAD]
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, command in action.choices.items():
                lines += _command(name, command)
    return "\n".join(lines)


def _command(name: str, command: argparse.ArgumentParser) -> list[str]:
    actions = [a for a in command._actions if not isinstance(a, argparse._HelpAction)]
    places = [_place(action) for action in actions if not action.option_strings]
    options = " [OPTIONS]" if any(action.option_strings for action in actions) else ""
    usage = " ".join([name, *places]) + options
    rows = [f"| {_name(a)} | {_said(a)} | {_usual(a)} |" for a in actions]
    text = str(command.description)
    return [
        f"## {name}\n",
        f"`elastomer-friction {usage}`\n",
        f"{text[0].upper()}{text[1:]}.\n",
        *(["| argument | meaning | default |", "|---|---|---|", *rows, ""] if rows else []),
    ]


def _place(action: argparse.Action) -> str:
    name = str(action.metavar or action.dest).upper().replace("|", " or ")
    forms = {"*": f"[{name} …]", "?": f"[{name}]", "+": f"{name} …"}
    return forms.get(str(action.nargs), name)


def _name(action: argparse.Action) -> str:
    if not action.option_strings:
        return f"`{_place(action)}`"
    value = "" if action.nargs == 0 else f" {action.metavar or action.dest.upper()}"
    return f"`{', '.join(action.option_strings)}{value}`"


def _said(action: argparse.Action) -> str:
    text = (action.help or "").replace("%%", "%").replace("%(default)s", str(action.default))
    return text.replace("|", "\\|")


def _usual(action: argparse.Action) -> str:
    nothing = action.default in (None, False, []) or action.default is argparse.SUPPRESS
    return "" if nothing else f"`{action.default}`"


PAGES: dict[str, Callable[[], str]] = {
    "README.md": index_page,
    "commands.md": commands_page,
    "keys.md": keys_page,
    "results.md": results_page,
}


def write_pages(folder: Path) -> list[Path]:
    """Write every page to a folder, which is made if need be; return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, page in PAGES.items():
        (folder / name).write_text(NOTE + page().rstrip() + "\n", encoding="utf-8")
    return [folder / name for name in PAGES]
