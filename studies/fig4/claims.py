"""Claims of the paper on figure 4, judged from the numbers of this study."""

from contextlib import suppress

import numpy as np

from elastomer_friction.workflow import report

RATE = 2.4  # b of figure 4
TYPICAL_SPACING = 2e-6  # m: L = 0.01 m with the 5000 elements the paper calls typical


def example_rate(results: report.Results) -> report.Claim:
    """Judge b = 2.4 of figure 4 by the spacing at which it occurs."""
    texts, spacings = [], {}
    for group, label in (("", "converged"), ("/paper_step", "implicit Euler")):
        with suppress(report.NotGiven):
            spacing, rate, error = _over_spacing(results, f"fig4{group}")
            typical = int(np.abs(np.log(spacing / TYPICAL_SPACING)).argmin())
            off = report.plus_minus(error[typical], f"{error[typical]:.2f}")
            texts.append(
                f"{label}: b = {rate[typical]:.2f}{off} at Δx = {1e6 * spacing[typical]:.3g} µm, "
                f"{rate.min():.2f} … {rate.max():.2f} over {rate.size} spacings"
            )
            at, at_error = _crossing(np.log(spacing), np.log(rate / RATE), error / rate)
            micrometres = 1e6 * np.exp(at)
            at_error *= micrometres
            off = report.plus_minus(at_error, f"{at_error:.1g}")
            spacings[group] = f"Δx = {micrometres:.2g}{off} µm"
    report.needed(texts)
    verdict = f"{report.HOLDS} if {spacings['']}" if "" in spacings else report.NOT_FOUND
    if verdict == report.NOT_FOUND and spacings:
        verdict = f"{report.ONLY_COARSE}, {spacings['/paper_step']}"
    text = "Figure 4: b = 2.4 (its spacing is not printed; N is typically 5000, Δx = 2 µm)"
    errors = report.per_point(results["fig4"]) if "fig4" in results else "not known"
    return report.Claim(text, f"{RATE:g}", "; ".join(texts), errors, verdict)


def _over_spacing(results: report.Results, key: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return spacing, b and its error where fitted; raise NotGiven if more than spacing varies."""
    dataset = report.given(results, key, "relaxation_rate")
    report.needed(dataset.relaxation_rate.size == dataset.spacing.size)
    rate, error = dataset.relaxation_rate.values.ravel(), dataset.relaxation_rate_error
    known = np.isfinite(rate)
    report.needed(known.any())
    return dataset.spacing.values[known], rate[known], error.values.ravel()[known]


def _crossing(x: np.ndarray, y: np.ndarray, error: np.ndarray) -> tuple[float, float]:
    """Return (x, error of x) where y first changes sign, by linear interpolation, or raise."""
    change = np.flatnonzero(np.sign(y[1:]) != np.sign(y[:-1]))
    report.needed(change.size)
    k = change[0]
    slope = (y[k + 1] - y[k]) / (x[k + 1] - x[k])
    return float(x[k] - y[k] / slope), float(abs(max(error[k], error[k + 1]) / slope))


CLAIMS = (example_rate,)
