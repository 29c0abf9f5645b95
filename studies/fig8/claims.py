"""Claims of the paper on the exponent (eq. 13), judged from figures 8 and 7."""

import math

import numpy as np

from elastomer_friction.workflow import report

ALPHA_TOLERANCE = 0.1  # absolute, of alpha: the distance of the paper's values of H


def exponent_converged(results: report.Results) -> report.Claim:
    """Judge alpha = 1 - H above x = 1 (eq. 13), converged in time."""
    return _exponent(results, "", "converged in time")


def exponent_paper_step(results: report.Results) -> report.Claim:
    """Judge alpha = 1 - H above x = 1 (eq. 13), implicit Euler at one step per spacing."""
    return _exponent(results, "/paper_step", "implicit Euler, one step per Δx")


def _exponent(results: report.Results, group: str, label: str) -> report.Claim:
    name = "fig8" if "alpha" in results.get(f"fig8{group}", ()) else "fig7"
    dataset = report.given(results, name + group, "alpha")
    dataset = dataset.isel(hurst=np.isfinite(dataset.alpha.values))
    report.needed(dataset.hurst.size)
    off = (dataset.alpha - (1.0 - dataset.hurst)).values
    worst = int(np.abs(off).argmax())
    free = (dataset.alpha_free - (1.0 - dataset.hurst)).values
    factor = dataset.alpha_prefactor.values
    error = float(dataset.alpha_error[worst])
    verdict = report.judge(abs(off[worst]), error, ALPHA_TOLERANCE)
    within = f"{report.HOLDS} within {math.ceil(100.0 * abs(off[worst]) - 1e-9) / 100.0:.2f}"
    close = int((np.abs(off) <= ALPHA_TOLERANCE).sum())
    if verdict == report.NOT_FOUND and 2 * close > off.size:
        verdict = f"{report.HOLDS} within {ALPHA_TOLERANCE:g} for {close} of {off.size} H"
    return report.Claim(
        f"α = 1 − H for v₁τq_max > 1 (eq. 13, figure 8), {label}",
        "1 − H",
        f"α − (1 − H) = {off.min():+.3f} … {off.max():+.3f}, largest at "
        f"H = {float(dataset.hurst[worst]):g}, with b(1) = 1; with a free prefactor, "
        f"{np.nanmin(factor):.2f} … {np.nanmax(factor):.2f}, {np.nanmin(free):+.3f} … "
        f"{np.nanmax(free):+.3f}; "
        f"{dataset.hurst.size} H, {int(dataset.alpha_points.sum())} points of {name}",
        report.plus_minus(error, f"{error:.3f}").strip(),
        verdict if " of " in verdict else report.reworded(verdict, within),
    )


CLAIMS = (exponent_converged, exponent_paper_step)
