"""Tests of kernels/rheology, one module per module."""
