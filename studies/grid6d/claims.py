"""Claims of the paper on steps of several sizes, judged from the six-dimensional grid."""

import numpy as np
import xarray as xr

from elastomer_friction.studies.style import NEARLY_FULL, usable
from elastomer_friction.workflow import report


def jump_over_step(results: report.Results) -> report.Claim:
    """Judge that the jump is in proportion to the step (eqs. 9 to 12)."""
    dataset = report.given(results, "grid6d", "jump", "mu_1")
    report.needed(dataset.velocity_step.size > 1)
    per_step = dataset.jump / dataset.velocity_step
    up, down = (per_step.sel(velocity_step=f(dataset.velocity_step)) for f in (max, min))
    ratio = (up / down).where(dataset.contact_fraction.isel(velocity_step=0) < NEARLY_FULL)
    known = ratio.values[np.isfinite(ratio.values)]
    report.needed(known.size)
    last, first = float(dataset.velocity_step.max()), float(dataset.velocity_step.min())
    worst = float(known[np.abs(known - 1.0).argmax()])
    by_sums = (np.log1p(last) / last) / (np.log1p(first) / first)
    error = float((dataset.jump_error / np.abs(dataset.jump)).median())
    return report.Claim(
        "The jump is in proportion to the velocity step (eqs. 9 to 12)",
        "1",
        f"(Δµ₀/Δv at {last:+.0%} v₁)/(at {first:+.0%} v₁) = {report.spread(known)}, "
        f"{worst:.2f} at worst; {by_sums:.2f} would be small steps summed up; {known.size} points "
        "short of full contact",
        f"{report.percent(error, 1)} a point",
        report.judge(abs(worst - 1.0), error, 0.05),
    )


def rate_after_step(results: report.Results) -> report.Claim:
    """Judge that eq. 13 takes v1: b would then be equal after steps up and down from v1."""
    dataset = report.given(
        results, "grid6d", "relaxation_rate", "relaxation_rate_error", "fit_status", "mu_1"
    )
    report.needed(dataset.velocity_step.size > 1)
    rough = (dataset.speed_ratio > 1.0) & (dataset.hurst < 1.0)  # where b depends on the velocity
    logs = xr.where(usable(dataset) & rough, np.log(dataset.relaxation_rate), np.nan)
    up, down = (logs.sel(velocity_step=f(dataset.velocity_step)) for f in (max, min))
    last, first = float(dataset.velocity_step.max()), float(dataset.velocity_step.min())
    sensitivity = (up - down) / np.log((1.0 + last) / (1.0 + first)) / (1.0 - dataset.hurst)
    known = sensitivity.values[np.isfinite(sensitivity.values)]
    report.needed(known.size > 1)
    middle = float(np.median(known))
    return report.Claim(
        "The rate of eq. 13 is that of the velocity before the step",
        "0: b the same after steps of all sizes from one v₁",
        f"b ∝ v₂^(s (1−H)) at one v₁ with s = {report.spread(known)}: 1 is the velocity after "
        f"the step; {known.size} pairs with x > 1, H < 1",
        report.per_point(dataset),
        report.judge(abs(middle), float(np.std(known) / np.sqrt(known.size))),
    )


CLAIMS = (jump_over_step, rate_after_step)
