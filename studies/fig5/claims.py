"""Claims of the paper on slow sliding (eq. 9), judged from figures 3 and 5."""

from collections.abc import Callable
from contextlib import suppress

import numpy as np
import xarray as xr

from elastomer_friction.studies.style import normalised
from elastomer_friction.workflow import report
from elastomer_friction.workflow.kinetic_law import PLATEAU

FLAT = 0.9  # share of its largest value from which mu_1 counts as on the plateau
SLOW = 0.5  # x below which sliding is slow


def slow_jump(results: report.Results) -> report.Claim:
    """Judge zeta -> 1 at low speed (eq. 9)."""
    return _slow(results, "ζ = (Δµ₀/µ₁)/(Δv/v₁) → 1 at low speed (eq. 9)", _zeta)


def slow_steady(results: report.Results) -> report.Claim:
    """Judge xi -> 1 at low speed (eq. 9)."""
    return _slow(results, "ξ = ((µ₂ − µ₁)/µ₁)/(Δv/v₁) → 1 at low speed (eq. 9)", _xi)


def _slow(results: report.Results, text: str, law: Callable) -> report.Claim:
    """Judge a ratio by its value in figures 3 and 5; its error needs the curves of figure 3."""
    values, texts, error = [], [], np.nan
    for name in ("fig3", "fig5"):
        with suppress(report.NotGiven):
            dataset = report.given(results, name, "mu_1", "mu_2", "jump")
            ratio, ratio_error = law(dataset.where(dataset.speed_ratio < SLOW))
            known = ratio.values[np.isfinite(ratio.values)]
            report.needed(known.size)
            values.append(known)
            texts.append(
                f"{known.mean():.4f} ({known.min():.4f} … {known.max():.4f}, {known.size} points "
                f"with x < {SLOW:g}, {name})"
            )
            if ratio_error is not None:
                error = report.mean_error(ratio_error)
    report.needed(values)
    deviation = float(np.abs(np.concatenate(values) - 1.0).max())
    unknown = not np.isfinite(error)
    shown = "not known without the curves of fig3" if unknown else f"± {error:.1g}"
    return report.Claim(
        text, "1", "; ".join(texts), shown, report.judge(deviation, 0.0 if unknown else error)
    )


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
    """Return xi and a bound of its error; xi is zeta minus the relaxing mu*/mu_1/(dv/v1)."""
    mu, step = points.mu_1, points.velocity_step
    xi = (points.mu_2 - mu) / mu / step
    zeta, error = _zeta(points)
    if error is None:
        return xi, None
    unknown = np.abs(zeta - xi)  # bound of the error of the relaxing part where it is not fitted
    fitted = points.amplitude_error / mu / np.abs(step)
    return xi, error + fitted.fillna(unknown)


def plateau_over_force(results: report.Results) -> report.Claim:
    """Judge that the plateau of the jump (eq. 11) is the same for all normal forces.

    The plateau, region III, begins at the speed at which mu_1 reaches FLAT times its largest value.
    Forces whose largest mu_1 does not exceed grad z have none.
    """
    dataset = report.given(results, "fig5", "mu_1", "jump")
    report.needed(dataset.normal_force.size > 1)
    bars = normalised(dataset)
    most = bars.mu_bar.max("velocity")
    begun = ((bars.mu_bar >= FLAT * most) & (most > 1.0)).cumsum("velocity") > 0
    jump = bars.jump_bar.where(begun)
    others = [dim for dim in jump.dims if dim != "normal_force"]
    least, largest = jump.min(others), jump.max(others)
    known = np.flatnonzero(np.isfinite(least.values))
    report.needed(known.size > 1)
    force = dataset.normal_force.values[known]
    deviation = float(np.abs(jump / PLATEAU - 1.0).max())
    error = float((dataset.jump_error / np.abs(dataset.jump)).where(begun).median())
    low, high = (int(known[k]) for k in (0, -1))
    return report.Claim(
        "Plateau (Δµ₀/∇z)/(Δv/v₁) = 0.4 at all normal forces (eq. 11)",
        f"{PLATEAU:g}",
        f"{float(least[low]):.3f} … {float(largest[low]):.3f} at F_N = {force[0]:.2g} N, "
        f"{float(least[high]):.3f} … {float(largest[high]):.3f} at {force[-1]:.2g} N, "
        f"{float(jump.min()):.3f} … {float(jump.max()):.3f} in all; {int(jump.count())} points",
        f"{report.percent(error, 1)} a point",
        report.judge(deviation, error),
    )


CLAIMS = (slow_jump, slow_steady, plateau_over_force)
