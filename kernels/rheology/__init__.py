"""Laws of the elastomer: the response of an element in one time step.

Each law has its own file; the march and the sweep dispatch on its type.
"""
