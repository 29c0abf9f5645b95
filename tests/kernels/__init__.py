"""Tests of the numerical core, one module per module of `kernels`."""
