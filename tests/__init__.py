"""Test suite: run `python -m pytest` in the root of the repository."""
