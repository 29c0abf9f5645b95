"""Steady sliding of elements that remember only u, found from spans of sixteen samples.

The reference, model/steady.py, visits every sample. This package computes the same result faster
for many loads on one line. ``spans`` holds sums and extremes of sixteen consecutive samples, and
the indentations above which a whole span stays in contact; it joins short lines for one call.
``span_sliding`` carries the elements once round the line and solves for the indentation under a
load.
"""
