"""The elastomer as a half-space under surfaces: contact, sliding, velocity jumps, programmes.

Surfaces are periodic squares of N x N elements, or N m x N m samples; the last axis is x, the
direction of sliding. Units are those of kernels/__init__.py, with E* in units of its relaxed value
and pressures in units of E* h/dx, so that

    p(q, t) = -(|q|/2) E*(t) u(q, t)   for q != 0,     mean pressure = load/N.

On a layer (interface/layer.py) |q|/2 is divided by its ratio of compliances. A map with a single
row is a line contact in plane strain.
"""
