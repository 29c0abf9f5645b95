"""What a user can put right: reported as one line, exit status 2."""

LONGEST = 600  # characters of a line


class UserError(Exception):
    """Wrong input or an environment that cannot be used; the message says what would be right.

    One line, but for the odd table. Whatever is put into a line, any terminal can show it.
    """

    def __init__(self, *lines: str) -> None:
        """Keep the lines of the message."""
        super().__init__(*map(_shown, lines))

    def __str__(self) -> str:
        """Return the message."""
        return "\n".join(self.args)


def _shown(line: str) -> str:
    """Return a line without control characters, cut in the middle where it is endless."""
    text = "".join(c if c.isprintable() else repr(c)[1:-1] for c in str(line))
    half = LONGEST // 2
    return text if len(text) <= LONGEST else f"{text[:half]} … {text[-half:]}"
