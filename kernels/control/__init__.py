"""What presses elastomer and line together: every step it gives the indentation.

A control is a file here; the march reaches it by its type.
"""
