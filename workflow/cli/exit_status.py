"""Exit statuses of all commands."""

DONE = 0
WRONG = 2  # invalid input or unusable environment
FAILED = 3  # done, but problems failed or faults were found
RESUMABLE = 130  # interrupted by the user or the batch system
