"""Input of the active-set march, and rise and advance, which decide whether an element touches."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel
from ...rheology.kelvin import Kelvin
from ..steady.span_sweep import DecayFactors
from ..steady.spans import Spans


class SteadyState(NamedTuple):
    """Steady sliding at one speed, by spans of the line (steady/spans.py)."""

    decay: DecayFactors
    thresholds: np.ndarray  # indentation from which a whole span touches (steady/thresholds.py)
    entered: np.ndarray  # displacement of the element that enters each span (contact_pieces.py)
    d: float  # indentation


class JumpProblem(NamedTuple):
    """A line, and steady sliding on it before and after the velocity jump."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    before: Kelvin  # law for steps of one sample at v1
    law: Kelvin  # the same at v2
    start: SteadyState  # at v1
    end: SteadyState  # at v2
    rate: float  # d' in h/tau just after the velocity jump


@kernel
def indentation_advance(law, d, previous):
    """Return D(t) = d(t) - E d(t - 1); as 1 - E = 1/K is used, no digits are lost near E = 1."""
    return (d - previous) + previous / law.stiffness


@kernel
def line_rise(law, z, upstream):
    """Return a_j = z_j - E z_(j+1). z : z_j. upstream : z_(j+1).

    An element that arrives from contact upstream overlaps the line by d - c = D - a_j.
    """
    return (z - upstream) + upstream / law.stiffness
