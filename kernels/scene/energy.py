"""Work, stored energy and dissipated energy of the elements, step by step.

The units of the retardation form (rheology/retardation.py) store y^2 / (2 J) and dissipate
lambda/J times the square of their rate; the glassy spring stores J_g p^2 / 2. These energies are
exact for the force that the scheme assumes within a step. Then

    work = change of stored energy + dissipated energy + closing work,

where the closing work is the work of the line over gaps that close within a step, because a force
counts for the whole step in which an element is touched. With a dashpot as the only branch, the
balance holds to rounding and the closing work is of first order in the step. With a glassy modulus,
the error of the balance and the closing work are of second order.
Source: R. M. Christensen, Theory of Viscoelasticity, 2nd ed. (Academic Press, 1982), ch. 3.
"""

import math
from typing import NamedTuple

import numpy as np

from ..body.ground import fill_heights
from ..compile.jit import kernel
from ..rheology.law import displacement

ENERGIES = ("stored_energy", "dissipated_energy", "work", "closing_work")


class EnergyRecord(NamedTuple):
    """Energies at the recorded steps, and their running sums."""

    energies: np.ndarray  # shape (4, recorded), in the order of ENERGIES, in 4 G L h^2; all but
    # the first are sums since the start
    sums: np.ndarray  # dissipated energy, work, closing work since the start, in 4 G dx h^2


@kernel
def stored_energy(form, memory, p):
    """Return the stored energy of the elements, in 4 G L h^2.

    form : of the material, a Retardation. memory : shape (K, n), p : shape (n,).
    """
    total = 0.0
    for i in range(p.size):
        total += form.glass * p[i] ** 2
    for k in range(form.times.size):
        units = 0.0
        for i in range(p.size):
            units += memory[k, i] ** 2
        total += units / form.compliances[k]
    return 0.5 * total / p.size


@kernel
def record_energies(record, k, form, elements):
    """Record the energies of a step in column k; elements : at the end of the step."""
    record.energies[0, k] = stored_energy(form, elements.memory, elements.p)
    for entry in range(3):
        record.energies[entry + 1, k] = record.sums[entry] / elements.p.size


@kernel
def add_step_energies(body, law, record, step, dt, before, after):
    """Add the energies of a step to the running sums; before, after : Elements at its ends.

    ``work`` is the distance by which the line moved towards an element, ``closing`` the part of it
    that closed a gap, in h.
    """
    form, share, n = body.form, 0.5 * law.linear, before.p.size
    old, new = np.empty(n), np.empty(n)
    fill_heights(body.ground, step.before, 0, old)
    fill_heights(body.ground, step.after, 0, new)
    was_u = displacement(form, before.memory, before.p)
    u = displacement(form, after.memory, after.p)
    for i in range(n):
        work = (old[i] - new[i]) + (after.d - before.d)
        closing = ((old[i] - before.d) - was_u[i]) - ((new[i] - after.d) - u[i])
        mean = after.p[i] + share * (before.p[i] - after.p[i])
        record.sums[1] += mean * work
        record.sums[2] += mean * closing
    for k in range(form.times.size):
        record.sums[0] += _dissipated(form, law, dt, k, before.memory[k], before.p, after.p)


@kernel
def _dissipated(form, law, dt, k, y, p, new):
    """Return the energy dissipated by units k in a step, lambda/J int (dy/dt)^2 dt.

    Under a linear force dy/dt = r + q exp(-t / lambda). Its mean square is the square of its mean
    plus its variance, which for x = dt / lambda is q^2 (1 - E)^2 (coth(x/2) / 2 - 1/x) / x.
    """
    time, compliance = form.times[k], form.compliances[k]
    x = dt / time
    decayed = -math.expm1(-x)
    spread = x / 12.0 if x < 1e-3 else 0.5 / math.tanh(0.5 * x) - 1.0 / x
    means = variances = 0.0
    for i in range(y.size):
        first = law.linear * p[i] + (1.0 - law.linear) * new[i]
        moved = -decayed * y[i] - law.fresh[k] * new[i] - law.stale[k] * p[i]
        q = y[i] + compliance * (first - (new[i] - first) / x)
        means += moved**2
        variances += q**2
    return (means / x + variances * decayed**2 * spread) / compliance
