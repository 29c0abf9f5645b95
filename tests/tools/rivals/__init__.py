"""Other ways to do the same work, for ``make bench``: none of them is part of the program."""
