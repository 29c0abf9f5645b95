"""Tests of kernels/surfaces, one module per module."""
