"""Tests of kernels/control, one module per module."""
