"""Steady sliding of elements that remember only u, found from spans of sixteen samples.

The reference, model/steady.py, visits every sample. This package computes the same result faster
for many loads on one line. ``spans`` holds sums and extremes of sixteen consecutive samples.
``thresholds`` gives the indentations above which a whole span stays in contact. ``span_sweep``
carries the elements once round the line and can list the contacts (``contact_pieces``).
``span_indentation`` solves for the indentation under a load. ``stack`` joins short lines for one
call.
"""
