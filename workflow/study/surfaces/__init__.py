"""Surfaces: the table [surface], and the reading and preparation of measured lines.

It depends on the spectra of the kernels and on the settings, and on no later stage.
"""
