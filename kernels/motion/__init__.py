"""Motion of the line: marched samples, time steps, and elements on their way between samples.

A motion of another kind is a file here that starts and shifts as slide.py does.
"""
