"""The page of every command, made of the parsers of the command line."""

import argparse

from ..cli import command_parser

HEAD = """# Every command

The command line is `elastomer-friction COMMAND`. Every command answers `--help`. A command that is
given wrong input prints one line that names it, and changes nothing. The exit status is 0 when a
command is done, 2 for wrong input or surroundings, 3 when it is done but for problems that failed
or when `verify` finds a fault, and 130 when it was interrupted. A run that was interrupted goes on
where it ended when it is started again.
"""


def commands_page() -> str:
    """Return the page of commands as Markdown."""
    parser = command_parser()
    lines = [HEAD]
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
