"""Friction of steady sliding and of velocity jumps, under many loads on many lines.

A steady state has full or partial contact. In full contact the sums over the whole line give the
indentation and friction in closed form (``loads``). In partial contact, sweeps by spans give the
indentation (``steady/``), and friction follows by one of two methods.

*Between the samples.* A band-limited line with enough samples per spacing is interpolated by a
polynomial of degree seven between neighbouring samples (``smooth_line``). ``events`` carries an
element once round this smooth line. The element lands where the line reaches its free
displacement, and leaves where its pressure vanishes. Between two such events eqs. 4 and 5 are
integrals of polynomials or exponentials. Bounds of heights and slopes show that most intervals
have no event, so no root is sought there; spans of sixteen intervals are passed at once.
``between_samples`` solves the load balance by Newton's method, with one such turn per iteration.
The last correction of d enters mu to first order; d' is found after each velocity jump.
The result does not depend on the sampling.

*At the samples.* Other lines, and states in which rounding prevents the first method, use the
quadrature of model/friction.py.

``loads`` runs the sweeps for several lines in one call. ``steady_friction`` is the entry point: it
selects the method and returns a ``SteadySliding``.
"""
