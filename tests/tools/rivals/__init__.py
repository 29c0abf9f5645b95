"""Other implementations of the same work, for ``make bench``; not part of the program."""
