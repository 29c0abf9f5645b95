"""Motion of the line: marched samples, time steps, and elements between samples.

A new kind of motion is a new file here that starts and shifts as slide.py does.
"""
