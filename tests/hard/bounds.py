"""How large a residual may be: what rounding the state once explains, and no more."""

import numpy as np

EPS = np.finfo(float).eps
MARGIN = 16.0


def bounds(motion) -> dict[str, float]:
    """Return the largest residual of each kind (studies/stability/probe.py) that is allowed.

    Thresholds z - w, of samples no higher than the highest possible indentation, and the
    indentation d are rounded to eps of their size; a step multiplies their difference, the
    force, by the stiffness K. Relative to the load n Fbar the n' touching elements lose
    eps K (n'^1/2 height + n' d) / (n Fbar); d itself loses eps height / d. And K (1 - E) = 1,
    the force of an element at rest, holds to eps K.
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


def assert_stable(motion, found: dict[str, float]) -> None:
    """Check that every residual is within its bound."""
    allowed = bounds(motion)
    assert found.keys() == allowed.keys()
    beyond = {k: (found[k], allowed[k]) for k in allowed if not found[k] <= allowed[k]}
    assert not beyond, f"(found, allowed): {beyond}"
