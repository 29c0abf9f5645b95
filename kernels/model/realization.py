"""One realization of the paper: a line slides steadily, its velocity jumps, friction relaxes.

This function is the complete model. Tests compare the faster computation (quick/) with it.
Source: Li et al. (2014), eqs. 1 to 5, doi:10.1038/srep05795.
"""

from typing import NamedTuple

import numpy as np

from ..lines.line import Line
from ..rheology.kelvin import SCHEMES
from .force import ConstantForce
from .friction import lagged_slope, quadrature, sliding_friction, steady_step_average
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
    line: Line,
    load: float,
    speed: float,
    ratio: float,
    scheme: str,
    kept_steps: np.ndarray,
    stepped: bool = False,
) -> Realization:
    """Return the friction of Kelvin elements on one line before, at and after a velocity jump.

    load : Fbar = F_N/(4 G L h). speed : vbar = v1 tau/dx > 0. ratio : v2/v1 > 0.
    scheme : a key of SCHEMES. kept_steps : increasing step numbers, from 1 on, at which mu is kept.
    In a step the line moves by one sample. The march averages mu over each step. The difference
    from the same average in steady sliding at v2 is added to mu_2: mu then tends to mu_2 exactly.

    stepped : whether mu_1, mu_2 and the jump are those of the steps too, so that they contain the
    error of a coarse step: mu_1 and mu_2 are averages over a step of steady sliding, and the jump
    leads from mu_1 to the first step at v2. In implicit Euler this is a jump of the velocity at the
    displacements of the steady state, as u' is a difference over the step.
    """
    z, slope, force = line.z, line.slope, load * line.z.size
    v1, v2 = speed, ratio * speed
    law_1, law_2 = (SCHEMES[scheme](1.0 / (line.steps_per_spacing * v)) for v in (v1, v2))

    one, _ = steady_sliding(law_1, z, force)
    two, _ = steady_sliding(law_2, z, force)
    mu_1, mu_2 = sliding_friction(line, one, v1, force), sliding_friction(line, two, v2, force)

    # At t0+ the displacements are those of steady sliding at v1, and the line moves at v2.
    before, after = (quadrature(z, slope, one.w, one.d, v1, v, force)[0] for v in (v1, v2))

    steps = np.union1d(1, kept_steps)
    weight = lagged_slope(slope, law_2.lag)
    mu, _, _, _ = march(law_2, ConstantForce(force), z, weight, one, steps, np.inf)
    settled = steady_step_average(z, slope, two, law_2.lag)
    if stepped:
        mu_1, mu_2 = steady_step_average(z, slope, one, law_1.lag), settled
        before, after = mu_1, mu[0]
    relaxation = mu_2 + (mu[np.isin(steps, kept_steps)] - settled)
    return Realization(mu_1, mu_2, after - before, relaxation, one.d)
