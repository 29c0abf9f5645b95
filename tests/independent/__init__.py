"""Solvers that share nothing with the kernels but the equations: slow, literal, independent."""
