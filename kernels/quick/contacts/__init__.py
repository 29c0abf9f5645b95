"""Friction of steady sliding and of velocity jumps, under many loads on many lines.

A steady state has full or partial contact. In full contact the sums over the whole line give the
indentation and friction in closed form (``loads``). In partial contact, sweeps by spans give the
indentation (``steady/``), and friction follows in one of two ways.

*From between the samples.* If the line is band-limited and has enough samples per spacing, it is a
smooth function: a polynomial of degree seven between neighbouring samples (``smooth_line``).
``events`` carries an element once round that function. The element lands where the line comes
down to its free displacement, and leaves where its pressure vanishes. Between two such events the
integrals of eqs. 4 and 5 are known in closed form. Most intervals have no event, which bounds of
their heights and slopes show without any root search; spans of sixteen intervals are passed at
once. ``between_samples`` applies Newton's method to the load balance with these turns, takes the
last correction of d to first order, and solves for d' after each velocity jump. The result does
not depend on the samples.

*From the samples.* Other lines, and states that rounding hides from the first way, use the
quadrature of model/friction.py. ``touching_samples`` lists what touches, ``pressed_samples``
arranges pressures so that sums over pressed spans need no visit to their samples, and ``pressure``
sums eqs. 3 to 5.

``loads`` runs the sweeps for several lines in one call. ``steady_friction`` is the entry point: it
selects the way and returns a ``SteadySliding``.
"""
