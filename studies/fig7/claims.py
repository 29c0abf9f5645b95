"""Claims of the paper on relaxation (eqs. 6, 13 to 16), judged from figure 7."""

from contextlib import suppress

import numpy as np
import xarray as xr

from elastomer_friction.studies.style import usable
from elastomer_friction.workflow import report
from elastomer_friction.workflow.kinetic_law import relaxation_rate
from elastomer_friction.workflow.reduce import FITTED, NOT_EXPONENTIAL

GOOD_FIT = 0.95  # smallest 1 - residual / total sum of squares of an accurate fit


def exponential_fits(results: report.Results) -> report.Claim:
    """Judge that an exponential fits the relaxation accurately (eq. 6)."""
    dataset = report.given(results, "fig7", "fit_quality", "fit_status")
    quality = dataset.fit_quality.values[(dataset.fit_status == FITTED).values]
    relaxing = quality.size + int((dataset.fit_status == NOT_EXPONENTIAL).sum())
    report.needed(quality.size)
    share = float((quality >= GOOD_FIT).sum() / relaxing)
    low, middle = np.percentile(quality, [5, 50])
    verdict = report.judge(1.0 - share)
    return report.Claim(
        "The relaxation is accurately fitted by an exponential (eq. 6)",
        "accurate",
        f"R² ≥ {GOOD_FIT:g} for {report.percent(share)} of {relaxing} relaxing points; of the "
        f"fits, median R² {middle:.4f}, one in 20 below {low:.3f}",
        report.per_point(dataset),
        report.reworded(verdict, f"{report.HOLDS} for {report.percent(share)} of the points"),
    )


CONVERGED, PAPER_STEP = "fig7", "fig7/paper_step"

VARIANTS = {CONVERGED: "converged", PAPER_STEP: "implicit Euler"}
RATE_VARIABLES = (
    "speed_ratio",
    "relaxation_rate",
    "relaxation_rate_error",
    "contact_fraction",
    "fit_status",
)

ALPHA_TOLERANCE = 0.1  # absolute, of alpha: the distance of the paper's values of H
MIN_SPEEDS = 3  # for the fit of alpha at one normal force


def slow_rate(results: report.Results) -> report.Claim:
    """Judge b = x below x = 1, i.e. D_c = 1/q_max, converged and with the paper's step."""
    ratios, texts = {}, []
    for key, label in VARIANTS.items():
        with suppress(report.NotGiven):
            points = _usable(results, key, below=1.0)
            x, rate = points.speed_ratio.values, points.relaxation_rate.values
            ratios[key] = rate / x
            slope = np.polyfit(np.log(x), np.log(rate), 1)[0]
            texts.append(
                f"{label}: b/x = {report.spread(ratios[key])}, b ∝ x^{slope:.2f}, median b = "
                f"{np.median(rate):.2f}, D_c q_max = {np.median(x / rate):.2f}, {x.size} points"
            )
    report.needed(CONVERGED in ratios)
    verdict = report.judge_factor(ratios[CONVERGED])
    factor = report.typical_factor(ratios.get(PAPER_STEP, np.array([np.inf])))
    if verdict == report.NOT_FOUND and factor <= report.FACTOR:
        verdict = f"{report.ONLY_COARSE}, within a factor {factor:.2g}"
    return report.Claim(
        "b = v₁τq_max for v₁τq_max < 1: relaxation over the length D_c = 1/q_max (eqs. 13, 14)",
        "b/x = 1",
        "; ".join(texts),
        report.per_point(results[CONVERGED]),
        verdict,
    )


def relaxation_time(results: report.Results) -> report.Claim:
    """Judge the relaxation time above x = 1 (eq. 16)."""
    points = _usable(results, CONVERGED, above=1.0)
    law = relaxation_rate(points.speed_ratio.values, points.hurst.values)
    ratio = points.relaxation_rate.values / law
    return report.Claim(
        "Relaxation time τ^H (v q_max)^(H−1) for v₁τq_max > 1 (eq. 16), short of full contact",
        "b/x^(1−H) = 1",
        f"b/x^(1−H) = {report.spread(ratio)}, extremes {ratio.min():.2f} and {ratio.max():.2f}; "
        f"{ratio.size} points",
        report.per_point(results[CONVERGED]),
        report.judge_factor(ratio),
    )


def force_independence(results: report.Results) -> report.Claim:
    """Judge by the spread over F_N at equal H, dx, v1 that b does not depend on the force."""
    points = _usable(results, CONVERGED)
    log_rate = np.log(points.relaxation_rate).unstack("point")
    several = log_rate.count("normal_force") > 1
    deviation = log_rate.std("normal_force", ddof=1).where(several)
    report.needed(several.any())
    rms = float(np.sqrt((deviation**2).mean()))
    verdict = report.judge(float(np.expm1(rms)))
    extreme = float(np.exp((log_rate.max("normal_force") - log_rate.min("normal_force")).max()))
    force = points.normal_force.values
    return report.Claim(
        "b depends on v₁τq_max and H alone, not on the normal force (eq. 13)",
        "no spread",
        f"rms spread {report.percent(np.expm1(rms))} over F_N = {force.min():g} … {force.max():g} "
        f"N, largest ratio {extreme:.2f}; {int(several.sum())} combinations of H, Δx, v₁",
        report.per_point(results[CONVERGED]),
        verdict
        if verdict in (report.HOLDS, report.NOT_FOUND)
        else f"{verdict} (rms), ratio {extreme:.1f} at worst",
    )


def exponent_over_force(results: report.Results) -> report.Claim:
    """Judge by separate fits at each F_N that alpha depends on H alone (eq. 13)."""
    points = _usable(results, CONVERGED, above=1.0)
    hursts, forces = points.hurst.values, points.normal_force.values
    x, b = np.log(points.speed_ratio.values), np.log(points.relaxation_rate.values)
    exponents: dict[float, dict[float, float]] = {}
    for hurst, force in sorted(set(zip(hursts.tolist(), forces.tolist(), strict=True))):
        chosen = (hursts == hurst) & (forces == force)
        if np.unique(x[chosen]).size >= MIN_SPEEDS:
            exponents.setdefault(hurst, {})[force] = float(
                x[chosen] @ b[chosen] / (x[chosen] @ x[chosen])
            )
    several = {hurst: alphas for hurst, alphas in exponents.items() if len(alphas) > 1}
    report.needed(several)
    spreads = {hurst: max(a.values()) - min(a.values()) for hurst, a in several.items()}
    worst = max(spreads, key=lambda hurst: spreads[hurst])
    ratio = np.exp(b - (1.0 - hursts) * x)
    verdict = report.judge(spreads[worst], tolerance=ALPHA_TOLERANCE)
    return report.Claim(
        "α of eq. 13 depends on H alone, for v₁τq_max > 1",
        "no spread over F_N",
        f"α at one F_N each spreads by {spreads[worst]:.2f} at H = {worst:g}, from "
        f"{min(several[worst].values()):.2f} to {max(several[worst].values()):.2f}; b/x^(1−H) "
        f"= {ratio.min():.2f} … {ratio.max():.2f}; {len(several)} H",
        report.per_point(results[CONVERGED]),
        report.reworded(verdict, f"{report.HOLDS} within {spreads[worst]:.2f}"),
    )


def _usable(
    results: report.Results, key: str, above: float = 0.0, below: float = np.inf
) -> xr.Dataset:
    """Return the ``usable`` points with above < x < below, along "point".

    Raises NotGiven for fewer than two values of x.
    """
    dataset = report.given(results, key, *RATE_VARIABLES)
    points = dataset[list(RATE_VARIABLES)].stack(point=dataset.relaxation_rate.dims)
    x = points.speed_ratio
    chosen = (usable(points) & (x > above) & (x < below)).values
    report.needed(np.unique(x.values[chosen]).size > 1)
    return points.isel(point=chosen)


CLAIMS = (
    exponential_fits,
    slow_rate,
    relaxation_time,
    force_independence,
    exponent_over_force,
)
