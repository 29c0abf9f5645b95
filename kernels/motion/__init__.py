"""How the line moves over the elements: which of its samples are carried along, and who is where.

A motion is a file here; the march takes its steps in the order in which it is written.
"""
