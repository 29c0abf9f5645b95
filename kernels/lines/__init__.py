"""Rigid lines: how they are made, and the checks and origin that all lines share.

A line of another kind is a file here that ends in ``Line.from_samples``.
"""
