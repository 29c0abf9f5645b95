"""Test-suite: run `python -m pytest` from the top of the repository."""
