"""Steady sliding of elements that remember u alone: without marching, over the samples of a line.

model/steady.py visits every sample and is the reference. These files find the same for many loads
of one line: ``spans`` says what is known of sixteen samples in a row, ``carry`` is a sweep that
uses it and can list the contacts, ``sliding`` solves with it for the indentation.
"""
