"""Records of velocity steps whose parameters are known."""

import numpy as np

from elastomer_friction.workflow.kinetic_law import KineticLaw
from elastomer_friction.workflow.laboratory.record import Record

SPEEDS = np.geomspace(1e-6, 10.0, 100)
TAU, HURST, Q_MAX, SLOPE = 0.1, 0.6, 1e3, 0.2  # x = 1 at 10 mm/s


def noise(seed, n, size, correlation=0.0):
    """Return noise of the autocorrelation correlation^k, shape (n,)."""
    rng = np.random.default_rng(seed)
    values = rng.standard_normal(n) * np.sqrt(1.0 - correlation**2)
    values[0] = rng.standard_normal()
    for i in range(1, n):
        values[i] += correlation * values[i - 1]
    return size * values


def record(
    seed=0, *, mu=(0.3, 0.32), jump=0.05, rate=8.0, v=(0.1, 0.12), size=1e-3, correlation=0.0,
    span=2.0, n=400,
):  # fmt: skip
    """Return one step at time 0, halfway between two samples; noise of a standard deviation."""
    t = span * (np.arange(-n, n) + 0.5) / n
    decay = np.exp(-rate * np.clip(t, 0.0, None))
    friction = np.where(t < 0.0, mu[0], mu[1] + (mu[0] + jump - mu[1]) * decay)
    friction = friction + noise(seed, 2 * n, size, correlation)
    return Record(f"r{seed}.txt", t, np.where(t < 0.0, *v), friction)


def law(**changes):
    """Return a kinetic law, x = 1 at 10 mm/s."""
    settings = {"relaxation_time": TAU, "hurst": HURST, "q_max": Q_MAX, "rms_slope": SLOPE}
    friction = 1.3 * SLOPE * SPEEDS / (SPEEDS + 0.03)
    return KineticLaw(**{**settings, **changes}, velocity=SPEEDS, friction=friction)


def records(speeds, seed=0, size=2e-5, **changes):
    """Return a record of each speed, of steps up by a fifth, eight relaxation times long."""
    known = law(**changes)
    found = []
    for i, v in enumerate(speeds):
        mu = float(known.steady(v)), float(known.steady(1.2 * v))
        jump, rate = float(known.jump(v, 1.2 * v)), float(1.0 / known.relaxation_times(1.2 * v))
        one = record(
            100 * seed + i, mu=mu, jump=jump, rate=rate, v=(v, 1.2 * v), size=size, correlation=0.5,
            span=8.0 / rate, n=200,
        )  # fmt: skip
        found.append(one)
    return found


def write(path, one, header="time [s]  velocity [m/s]  friction"):
    """Write a record as a text file and return the path."""
    columns = np.column_stack([one.time, one.velocity, one.friction])
    np.savetxt(path, columns, header=header)
    return path
