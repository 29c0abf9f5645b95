"""Motion of the line: programmes, their time steps, marched samples, and shifts between samples.

A new kind of motion is a new file here with functions like those of slide.py.
"""
