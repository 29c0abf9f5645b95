"""Rigid lines: their construction, and the checks and origin common to all lines.

A new kind of line is a new file that ends in ``Line.from_samples``.
"""
