"""Tests of kernels/branches, one module per module."""
