"""How the line moves: which of its samples are carried along, and which element comes to which.

A motion of another kind is a file here that starts and shifts as slide.py does.
"""
