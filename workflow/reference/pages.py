"""All generated reference pages, and the page of commands from the command-line parsers."""

import argparse
from collections.abc import Callable
from pathlib import Path

from ..cli import command_parser
from .api import api_page
from .keys import keys_page

SHARED_ARGUMENTS = """## Arguments of several commands

| argument | meaning | commands |
|---|---|---|"""
MIN_SHARED_COMMANDS = 2  # arguments of this many commands are listed in the first table only
# Separates the introduction, written by hand, from the generated part.
MARK = "<!-- From here on written by `make docs` from the code; change the texts there. -->\n\n"


def commands_page() -> str:
    """Return the entries of all commands as Markdown."""
    parser = command_parser()
    commands = {
        name: (command, [a for a in command._actions if not isinstance(a, argparse._HelpAction)])
        for action in parser._actions
        if isinstance(action, argparse._SubParsersAction)
        for name, command in action.choices.items()
    }
    takers: dict[str, list[str]] = {}
    for name, (_, actions) in commands.items():
        for row in map(_row, actions):
            takers.setdefault(row, []).append(name)
    common = {row: names for row, names in takers.items() if len(names) >= MIN_SHARED_COMMANDS}
    lines = [SHARED_ARGUMENTS]
    for row, names in common.items():
        lines.append(f"{row} {', '.join(f'`{name}`' for name in names)} |")
    lines.append("")
    for name, (command, actions) in commands.items():
        rows = [row for row in map(_row, actions) if row not in common]
        lines += _command(name, str(command.description), actions, rows)
    return "\n".join(lines)


def _command(name: str, text: str, actions: list[argparse.Action], rows: list[str]) -> list[str]:
    places = [_place(action) for action in actions if not action.option_strings]
    options = " [OPTIONS]" if any(action.option_strings for action in actions) else ""
    usage = " ".join([name, *places]) + options
    return [
        f"## {name}\n",
        f"`elastomer-friction {usage}`\n",
        f"{text[0].upper()}{text[1:]}.\n",
        *(["| argument | meaning |", "|---|---|", *rows, ""] if rows else []),
    ]


def _row(action: argparse.Action) -> str:
    return f"| {_name(action)} | {_help(action)}{_default(action)} |"


def _place(action: argparse.Action) -> str:
    name = str(action.metavar or action.dest).upper().replace("|", " or ")
    forms = {"*": f"[{name} …]", "?": f"[{name}]", "+": f"{name} …"}
    return forms.get(str(action.nargs), name)


def _name(action: argparse.Action) -> str:
    if not action.option_strings:
        return f"`{_place(action)}`"
    choices = f"{{{','.join(map(str, action.choices))}}}" if action.choices else ""
    value = "" if action.nargs == 0 else f" {action.metavar or choices or action.dest.upper()}"
    return f"`{', '.join(action.option_strings)}{value}`"


def _help(action: argparse.Action) -> str:
    text = (action.help or "").replace("%%", "%").replace("%(default)s", str(action.default))
    return text.replace("|", "\\|")


def _default(action: argparse.Action) -> str:
    """Return the default as text to append to the help, or "" if the help states it."""
    has_none = action.default in (None, False, []) or action.default is argparse.SUPPRESS
    stated = has_none or "%(default)s" in (action.help or "")
    return "" if stated else f", by default `{action.default}`"


PAGES: dict[str, Callable[[], str]] = {
    "commands.md": commands_page,
    "keys.md": keys_page,
    "python.md": api_page,
}


def write_pages(folder: Path) -> list[Path]:
    """Write the generated part of every page of a folder, below its introduction."""
    for name, page in PAGES.items():
        introduction = (folder / name).read_text(encoding="utf-8").partition(MARK)[0]
        text = introduction + MARK + page().rstrip() + "\n"
        (folder / name).write_text(text, encoding="utf-8")
    return [folder / name for name in PAGES]
