"""Tests of kernels/lines, one module per module."""
