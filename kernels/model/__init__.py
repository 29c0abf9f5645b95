"""The complete model of the paper: slow, readable, and the reference in tests."""
