"""A line of Prony elements in blocks: a step visits only the blocks that can touch.

The elements are in blocks of 64. The line cannot touch a block over which it lies above a cap, and
the memory of a block without force needs no update because it is divided by its own decay
(scaled_units.py). If the indentation passes the cap, more blocks are chosen in the same step
(choice.py). The choice changes no bit. Tests compare the body with body/element_line.py.
"""

from .block_line import block_line
