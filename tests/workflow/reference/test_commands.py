"""The page of commands: every command, with its arguments and what they are without."""

from elastomer_friction.workflow.cli import command_parser
from elastomer_friction.workflow.reference.pages import commands_page

PAGE = commands_page()


def test_every_command_has_its_heading_and_its_usage():
    (commands,) = (action for action in command_parser()._actions if action.dest == "command")
    assert {"plan", "run", "figure", "prony"} <= set(commands.choices)
    for name in commands.choices:
        assert f"\n## {name}\n\n`elastomer-friction {name}" in PAGE


def test_an_option_is_named_with_its_meaning_and_default():
    assert "| `--accuracy ACCURACY` | as --set numerics.accuracy=0.01: 1% or 0.01 |" in PAGE
    assert "| `--set TABLE.KEY=VALUE` | override one setting" in PAGE
    assert "| folder of results, or path of the .nc file, by default `results` |" in PAGE


def test_what_several_commands_take_is_said_once_with_their_names():
    (row,) = (line for line in PAGE.splitlines() if line.startswith("| `STUDY` |"))
    assert row.endswith("| `plan`, `run`, `status`, `figure`, `table`, `animate` |")


def test_a_place_for_one_or_more_files_and_one_for_this_or_that():
    assert "\n`elastomer-friction fit FILE … [OPTIONS]`\n" in PAGE
    assert "| `[FOLDER or STUDY]` | a folder of results" in PAGE
