"""The command line from the inside: what a command prints, or the one line that refuses it."""

from elastomer_friction.workflow.cli import main


def output(capsys, *arguments: str) -> str:
    """Return what a command that succeeds prints to stdout; else it names scripts it runs."""
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


# Of a script that runs, of figures, and of machine code, which the first test that needs it makes.
NOTES = (
    "note: running /",
    "caption: ",
    "Compiling the kernels",
    "Waiting for another process that",
)


def besides_notes(err: str) -> list[str]:
    """Return the lines of stderr but for NOTES."""
    return [line for line in err.splitlines() if not line.startswith(NOTES)]


def facts(text: str) -> dict[str, str]:
    """Return the lines of a plan or a status by their first word."""
    return {line.split()[0]: line for line in text.splitlines()}
