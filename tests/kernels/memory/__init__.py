"""Tests of kernels/memory, one module per module."""
