"""What the active-set march is given, and the two numbers that say whether an element touches."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel
from ...rheology.kelvin import Kelvin
from ..steady.carry import Decay
from ..steady.spans import Spans


class SteadyState(NamedTuple):
    """Steady sliding at one speed, as the elements pass the spans of the line (steady/spans.py)."""

    decay: Decay
    stay: np.ndarray  # largest thresholds at the speed, of each whole span
    entered: np.ndarray  # with which displacement elements come to each span (steady/contacts.py)
    d: float  # indentation


class March(NamedTuple):
    """A line, and steady sliding on it before and after the velocity jump."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    before: Kelvin  # of steps of one sample at v1
    law: Kelvin  # the same at v2
    start: SteadyState  # at v1
    end: SteadyState  # and at v2
    rate: float  # d' in h/tau just after the velocity jump


@kernel
def advance(law, d, old):
    """Return D(t) = d(t) - E d(t - 1), with 1 - E = 1/K, which loses no digits near E = 1."""
    return (d - old) + old / law.stiffness


@kernel
def a_of(law, z, upstream):
    """Return a_j = z_j - E z_(j+1) of heights z_j and, upstream of it, z_(j+1).

    The overlap d - c of an element that comes from contact upstream is D - a_j.
    """
    return (z - upstream) + upstream / law.stiffness
