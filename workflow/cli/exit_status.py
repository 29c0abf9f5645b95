"""Exit statuses of all commands."""

DONE = 0
WRONG = 2  # wrong input or environment
FAILED = 3  # done, except for failed problems
RESUMABLE = 130  # interrupted
