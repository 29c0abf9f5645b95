"""What a user can put right: reported as one line, exit status 2."""


class UserError(Exception):
    """Wrong input or an environment that cannot be used; the message says what would be right."""
