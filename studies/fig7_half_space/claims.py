"""Claims of the paper on jump and relaxation, judged on a half-space."""

import numpy as np

from elastomer_friction.studies.style import normalised
from elastomer_friction.workflow import report
from elastomer_friction.workflow.kinetic_law import PLATEAU

KEY = "fig7_half_space"
KINETICS_VARIABLES = (
    "speed_ratio",
    "mu_1",
    "jump",
    "rms_slope",
    "alpha",
    "alpha_error",
    "alpha_bias",
)


def exponent_on_half_space(results: report.Results) -> report.Claim:
    """Judge alpha = 1 - H above x = 1 (eq. 13) on a half-space."""
    dataset = report.given(results, KEY, *KINETICS_VARIABLES)
    known = dataset.dropna("hurst", subset=["alpha"])
    report.needed(known.sizes["hurst"] > 1)
    alpha, hurst = known.alpha.values, known.hurst.values
    error = np.hypot(known.alpha_error, known.alpha_bias).values
    slope = np.polyfit(hurst, alpha, 1)[0]
    off = np.abs(alpha - (1.0 - hurst)) / np.maximum(1.0 - hurst, 0.1)
    exponents = ", ".join(
        f"{a:.2f}{report.plus_minus(e, f'{e:.2f}')} at H = {h:g}"
        for h, a, e in zip(hurst, alpha, error, strict=True)
    )
    return report.Claim(
        "On a half-space too: b = x^α with α = 1 − H for x > 1 (eq. 13)",
        "α = 1 − H",
        f"α = {exponents}; dα/dH = {slope:.2f}",
        report.per_point(dataset),
        report.judge(float(off.max()), float(error.max())),
    )


def plateau_on_half_space(results: report.Results) -> report.Claim:
    """Judge that the jump over slope and relative step has a plateau of 0.4 on a half-space."""
    dataset = report.given(results, KEY, *KINETICS_VARIABLES)
    points = normalised(dataset).where(dataset.speed_ratio > 3.0)
    fast = points.jump_bar.values[np.isfinite(points.jump_bar.values)]
    report.needed(fast.size)
    error = report.mean_error(points.jump_bar_error)
    return report.Claim(
        "On a half-space too: the jump over ∇z Δv/v₁ has a plateau of 0.4 (eq. 12)",
        "0.4",
        f"{report.spread(fast)} for x > 3",
        f"± {error:.1g}",
        report.judge(abs(float(fast.mean()) / PLATEAU - 1.0), error / PLATEAU),
    )


CLAIMS = (exponent_on_half_space, plateau_on_half_space)
