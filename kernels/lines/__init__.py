"""Rigid lines: their construction, and the checks and origin that all lines share.

A line of another kind has its own file, which ends in ``Line.from_samples``.
"""
