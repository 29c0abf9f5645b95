"""Fits to measured velocity steps."""
