"""The claims of the paper about the jump (eqs. 9 to 12); see workflow/claims.py."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from workflow.kinetic_law import PLATEAU, normalised_jump
from workflow.verdicts import TOLERANCE, Claim, Results, given, judge, mean_error, percent

SLOW = 0.5  # x below which sliding is slow
FLAT = 0.9  # share of its largest value from which mu_1 counts as on the plateau
MIDDLE = (0.3, 0.7)  # Hurst exponents of the plateau claim


def slow_jump(results: Results) -> Claim | None:
    """Judge zeta -> 1 at low speed (eq. 9)."""
    return _slow(results, "ζ = (Δµ₀/µ₁)/(Δv/v₁) → 1 at low speed (eq. 9)", _zeta)


def slow_steady(results: Results) -> Claim | None:
    """Judge xi -> 1 at low speed (eq. 9)."""
    return _slow(results, "ξ = ((µ₂ − µ₁)/µ₁)/(Δv/v₁) → 1 at low speed (eq. 9)", _xi)


def _slow(results: Results, text: str, law: Callable) -> Claim | None:
    """Judge a ratio by its value in figures 3 and 5; the error needs the curves of figure 3."""
    values, found, error = [], [], np.nan
    for name in ("fig3", "fig5"):
        dataset = given(results, name, "mu_1", "mu_2", "jump")
        if dataset is None:
            continue
        slow = dataset.where(dataset.speed_ratio < SLOW)
        ratio, ratio_error = law(slow)
        known = ratio.values[np.isfinite(ratio.values)]
        if known.size == 0:
            continue
        values.append(known)
        found.append(
            f"{known.mean():.4f} ({known.min():.4f} … {known.max():.4f}, {known.size} points "
            f"with x < {SLOW:g}, {name})"
        )
        if ratio_error is not None:
            error = mean_error(ratio_error)
    if not values:
        return None
    deviation = float(np.abs(np.concatenate(values) - 1.0).max())
    unknown = not np.isfinite(error)
    shown = "not known without the curves of fig3" if unknown else f"± {error:.1g}"
    return Claim(text, "1", "; ".join(found), shown, judge(deviation, 0.0 if unknown else error))


def _zeta(points: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray | None]:
    """Return zeta and its error.

    mu_1 and the jump come from the same lines; their covariance follows from the error of
    their sum, which is sample 0 of the curve.
    """
    mu, jump = points.mu_1, points.jump
    zeta = jump / mu / points.velocity_step
    if "mu" not in points:
        return zeta, None
    variances = points.mu_1_error**2, points.jump_error**2
    both = points.mu_error.isel(sample=0) ** 2 - sum(variances)
    relative = variances[0] / mu**2 + variances[1] / jump**2 - both / (mu * jump)
    return zeta, np.abs(zeta) * np.sqrt(np.maximum(relative, 0.0))


def _xi(points: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray | None]:
    """Return xi and a bound of its error: xi is zeta less the share mu*/mu_1 that relaxes."""
    mu, step = points.mu_1, points.velocity_step
    xi = (points.mu_2 - mu) / mu / step
    zeta, error = _zeta(points)
    if error is None:
        return xi, None
    unknown = np.abs(zeta - xi)  # nothing fitted: what relaxes is not known better than this
    fitted = points.amplitude_error / mu / np.abs(step)
    return xi, error + fitted.fillna(unknown)


def plateau(results: Results) -> Claim | None:
    """Judge the plateau of the jump (eq. 11), by the mean of each Hurst exponent."""
    dataset = given(results, "fig6", "mu_1", "jump")
    if dataset is None:
        return None
    inside = (dataset.hurst > MIDDLE[0] - 1e-9) & (dataset.hurst < MIDDLE[1] + 1e-9)
    chosen = dataset.isel(hurst=np.flatnonzero(inside))
    if chosen.hurst.size == 0:
        return None
    line = ("normal_force", "spacing", "roughness", "velocity", "velocity_step")
    flat = chosen.where(chosen.mu_1 >= FLAT * chosen.mu_1.max("velocity"))
    level = flat.jump / flat.rms_slope / flat.velocity_step
    error = flat.jump_error / flat.rms_slope / np.abs(flat.velocity_step)
    each = level.mean(line)
    errors = [mean_error(error.isel(hurst=[k])) for k in range(each.size)]
    parts = [
        f"{value:.3f} ± {e:.3f} at H = {hurst:g}"
        for hurst, value, e in zip(chosen.hurst.values, each.values, errors, strict=True)
    ]
    return Claim(
        "Plateau (Δµ₀/∇z)/(Δv/v₁) = 0.4 at high speed (eq. 11)",
        f"{PLATEAU:g}",
        f"mean {float(each.mean()):.3f}: {', '.join(parts)}; {int(level.count())} points with µ₁ "
        f"within {percent(1 - FLAT)} of its largest value",
        f"± {np.sqrt(np.sum(np.square(errors))) / each.size:.3f}",
        judge(float(np.abs(each / PLATEAU - 1.0).max()), max(errors) / PLATEAU),
    )


def interpolation(results: Results) -> Claim | None:
    """Judge the interpolation between both limits (eq. 12)."""
    dataset = given(results, "fig6", "mu_1", "jump")
    if dataset is None:
        return None
    mu = dataset.mu_1 / dataset.rms_slope
    law = dataset.rms_slope * dataset.velocity_step * normalised_jump(mu)
    deviation = (dataset.jump / law - 1.0).stack(point=dataset.mu_1.dims)
    worst = deviation.isel(point=int(np.nanargmax(np.abs(deviation.values))))
    rms = float(np.sqrt((deviation**2).mean()))
    largest = abs(float(worst))
    error = float((dataset.jump_error / np.abs(law)).median())
    verdict = judge(rms, 0.0, TOLERANCE)
    if verdict != judge(largest, 0.0, TOLERANCE):
        verdict += f" (rms), {percent(largest)} at worst"
    return Claim(
        "The jump follows eq. 12 from slow to fast sliding, for all H",
        "eq. 12",
        f"rms deviation {percent(rms, 1)}, largest {percent(largest)} at "
        f"H = {float(worst.hurst):g}, v₁ = {float(worst.velocity):.2g} m/s; {deviation.size} "
        "points",
        f"{percent(error, 1)} a point",
        verdict,
    )
