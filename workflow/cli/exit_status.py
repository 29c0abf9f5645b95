"""Exit status of every command."""

DONE = 0
WRONG = 2  # input or surroundings
FAILED = 3  # done, but for problems that failed
RESUMABLE = 130  # interrupted
