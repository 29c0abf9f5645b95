"""Controls: the indentation of every step under a prescribed load or indentation.

Each control has its own file; the march dispatches on its type.
"""
