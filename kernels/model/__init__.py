"""The model of the paper, whole: slow, readable, and the reference of every test."""
