"""Faster solution of the equations of ``model``, which is the reference of its tests."""
