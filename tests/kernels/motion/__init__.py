"""Tests of kernels/motion, one module per module."""
