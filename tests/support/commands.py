"""The command line in the process of a test: the output of a command, or its error message."""

from elastomer_friction.workflow.cli import main


def output(capsys, *arguments: str) -> str:
    """Return the stdout of a command that succeeds; stderr must hold only NOTES."""
    assert main(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert besides_notes(err) == []
    return out


def refusal(capsys, *arguments: str) -> str:
    """Return the one line on stderr of a command that fails."""
    assert main(list(arguments)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    (line,) = besides_notes(err)
    assert line.startswith("error: ")
    return f"{line}\n"


# Lines of stderr about scripts, figures, and compilation by the first test that needs a kernel.
NOTES = (
    "note: running /",
    "caption: ",
    "Compiling the kernels",
    "Waiting for another process that",
)


def besides_notes(err: str) -> list[str]:
    """Return the lines of stderr without NOTES."""
    return [line for line in err.splitlines() if not line.startswith(NOTES)]


def facts(text: str) -> dict[str, str]:
    """Return the lines of a plan or a status by their first word."""
    return {line.split()[0]: line for line in text.splitlines()}
