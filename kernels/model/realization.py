"""One realization of the paper: a line slides steadily, its velocity jumps, friction relaxes.

This function is the complete model. Tests compare the faster computation (quick/) with it.
Source: Li et al. (2014), eqs. 1 to 5, doi:10.1038/srep05795.
"""

from typing import NamedTuple

import numpy as np

from ..lines.line import Line
from ..rheology.kelvin import SCHEMES
from .force import ConstantForce
from .friction import lagged_slope, quadrature, sliding_friction, step_average
from .march import march
from .steady import steady_sliding


class Realization(NamedTuple):
    """Friction of one line; mu in h/dx, indentation in h over the deepest point."""

    mu_1: float  # of steady sliding at v1
    mu_2: float  # of steady sliding at v2
    jump: float  # mu(t0+) - mu_1
    mu: np.ndarray  # at the kept steps after the jump; it tends to mu_2
    indentation: float  # of steady sliding at v1


def realization(
    line: Line, load: float, speed: float, ratio: float, scheme: str, kept_steps: np.ndarray
) -> Realization:
    """Return the friction of Kelvin elements on one line before, at and after a velocity jump.

    load : Fbar = F_N/(4 G L h). speed : vbar = v1 tau/dx > 0. ratio : v2/v1 > 0.
    scheme : a key of SCHEMES. kept_steps : increasing step numbers, from 1 on, at which mu is kept.
    In a step the line moves by one sample. The march averages mu over each step. The difference
    from the same average in steady sliding at v2 is added to mu_2: mu then tends to mu_2 exactly.
    """
    z, slope, force = line.z, line.slope, load * line.z.size
    v1, v2 = speed, ratio * speed
    law_1, law_2 = (SCHEMES[scheme](1.0 / (line.steps_per_spacing * v)) for v in (v1, v2))

    one, _ = steady_sliding(law_1, z, force)
    two, _ = steady_sliding(law_2, z, force)
    mu_1, mu_2 = sliding_friction(line, one, v1, force), sliding_friction(line, two, v2, force)

    # At t0+ the displacements are those of steady sliding at v1, and the line moves at v2.
    before, after = (quadrature(z, slope, one.w, one.d, v1, v, force)[0] for v in (v1, v2))

    weight = lagged_slope(slope, law_2.lag)
    mu, _, _, _ = march(law_2, ConstantForce(force), z, weight, one, kept_steps, np.inf)
    settled = step_average(weight, z - two.w, two.d)
    return Realization(mu_1, mu_2, after - before, mu_2 + (mu - settled), one.d)
