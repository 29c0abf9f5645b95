"""Claims of the paper on the jump (eqs. 11 and 12), judged from figure 6."""

import numpy as np

from elastomer_friction.studies.style import normalised
from elastomer_friction.workflow import report
from elastomer_friction.workflow.kinetic_law import PLATEAU, normalised_jump

PLATEAU_SHARE = 0.9  # mu_1 over its largest value from which a point is on the plateau


def plateau(results: report.Results) -> report.Claim:
    """Judge the plateau of the jump (eq. 11) by its mean for each Hurst exponent."""
    dataset = report.given(results, "fig6", "mu_1", "jump")
    line = ("normal_force", "spacing", "roughness", "velocity", "velocity_step")
    flat = normalised(dataset.where(dataset.mu_1 >= PLATEAU_SHARE * dataset.mu_1.max("velocity")))
    plateaus = flat.jump_bar.mean(line)
    errors = [report.mean_error(flat.jump_bar_error.isel(hurst=[k])) for k in range(plateaus.size)]
    parts = [
        f"{value:.3f}{report.plus_minus(e, f'{e:.3f}')} at H = {hurst:g}"
        for hurst, value, e in zip(dataset.hurst.values, plateaus.values, errors, strict=True)
    ]
    error = float(np.sqrt(np.sum(np.square(errors)))) / plateaus.size
    return report.Claim(
        "Plateau (Δµ₀/∇z)/(Δv/v₁) = 0.4 at high speed (eq. 11)",
        f"{PLATEAU:g}",
        f"mean {float(plateaus.mean()):.3f}: {', '.join(parts)}; {int(flat.jump_bar.count())} "
        f"points with µ₁ within {report.percent(1 - PLATEAU_SHARE)} of its largest value, each "
        f"{float(flat.jump_bar.min()):.3f} … {float(flat.jump_bar.max()):.3f}",
        report.plus_minus(error, f"{error:.3f}").strip(),
        report.judge(float(np.abs(plateaus / PLATEAU - 1.0).max()), max(errors) / PLATEAU),
    )


def interpolation(results: report.Results) -> report.Claim:
    """Judge the interpolation between both limits (eq. 12)."""
    dataset = report.given(results, "fig6", "mu_1", "jump")
    mu = dataset.mu_1 / dataset.rms_slope
    law = dataset.rms_slope * dataset.velocity_step * normalised_jump(mu)
    deviation = (dataset.jump / law - 1.0).stack(point=dataset.mu_1.dims)
    worst = deviation.isel(point=int(np.nanargmax(np.abs(deviation.values))))
    rms = float(np.sqrt((deviation**2).mean()))
    largest = abs(float(worst))
    error = float((dataset.jump_error / np.abs(law)).median())
    verdict = report.judge(rms, 0.0, report.TOLERANCE)
    if verdict != report.judge(largest, 0.0, report.TOLERANCE):
        verdict += f" (rms), {report.percent(largest)} at worst"
    return report.Claim(
        "The jump follows eq. 12 from slow to fast sliding, for all H",
        "eq. 12",
        f"rms deviation {report.percent(rms, 1)}, largest {report.percent(largest)} at "
        f"H = {float(worst.hurst):g}, v₁ = {float(worst.velocity):.2g} m/s; {deviation.size} "
        "points",
        f"{report.percent(error, 1)} a point",
        verdict,
    )


CLAIMS = (plateau, interpolation)
