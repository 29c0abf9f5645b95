"""The command line from the inside: what a command prints, or the one line that refuses it."""

from workflow.cli import main


def output(capsys, *arguments: str) -> str:
    """Return what a command that succeeds prints to stdout; else it names scripts it runs."""
    assert main(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert [line for line in err.splitlines() if not line.startswith("note: runs /")] == []
    return out


def refusal(capsys, *arguments: str) -> str:
    """Return the one line on stderr of a command that fails."""
    assert main(list(arguments)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("error: ")
    assert err.count("\n") == 1
    assert err.endswith("\n")
    return err


def facts(text: str) -> dict[str, str]:
    """Return the lines of a plan or a status by their first word."""
    return {line.split()[0]: line for line in text.splitlines()}
