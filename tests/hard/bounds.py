"""Bounds of residuals: the effect of rounding the state once, times a margin."""

import numpy as np

EPS = np.finfo(float).eps
MARGIN = 16.0


def bounds(motion) -> dict[str, float]:
    """Return the largest allowed residual of each kind (studies/stability/probe.py).

    Thresholds z - w, of samples up to the highest possible indentation, and the indentation d have
    rounding errors of eps times their size. A step multiplies their difference by the stiffness K.
    The force of the n' touching elements, relative to the load n Fbar, has the error
    eps K (n'^1/2 height + n' d) / (n Fbar); d has the relative error eps height / d. The force of
    an element at rest, K (1 - E) = 1, has the error eps K.
    """
    stiffness, deepest, highest, touching = 1.0, np.inf, 0.0, 1
    for ratio in (1.0, motion.ratio):
        _, law = motion.step(ratio)
        (w, d), _ = motion.steady(law)
        stiffness = max(stiffness, law.stiffness)
        deepest, highest = min(deepest, d), max(highest, d)
        touching = max(touching, np.sum(motion.line.z - w < d))
    height = min(motion.line.z.max(), max(highest, motion.total))
    lost = (np.sqrt(touching) * height + touching * highest) / motion.total
    force = MARGIN * EPS * (1.0 + stiffness * (1.0 + lost))
    depth = MARGIN * EPS * (1.0 + stiffness + height / deepest)
    return {
        "balance": force,
        "mean": force,
        "contact": 1e-12,
        "energy": MARGIN * EPS * (1.0 + stiffness),
        "steady": depth,
        "march": depth,
        "falling": 0,
        "subnormal": 0,
        "not_finite": 0,
        "passes": 2 * motion.line.z.size + 3,
        "sweeps": motion.line.z.size + 60,
    }


def assert_stable(motion, residuals: dict[str, float]) -> None:
    """Assert that every residual is within its bound."""
    allowed = bounds(motion)
    assert residuals.keys() == allowed.keys()
    beyond = {k: (residuals[k], allowed[k]) for k in allowed if not residuals[k] <= allowed[k]}
    assert not beyond, f"(residuals, allowed): {beyond}"
