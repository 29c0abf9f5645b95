"""Rigid lines: their construction, common checks and common origin.

A new kind of line is a new file that ends in ``Line.from_samples``.
"""
