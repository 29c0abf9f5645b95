"""The complete model of the paper: slow, readable, the reference of the tests."""
