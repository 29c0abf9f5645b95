"""Laws of the elastomer: the constants of one time step, and what an element does in it.

A law is a file here; the march and the sweep reach it by its type.
"""
