"""How well the closed-form law (eqs. 12 to 15) predicts the simulated curves."""

import numpy as np
import xarray as xr

from elastomer_friction.workflow.kinetic_law import normalised_jump, relaxation_rate

LIMITS = (0.01, 0.05, 0.20)


def law_curve(dataset: xr.Dataset, time_below_one: bool = False) -> xr.DataArray:
    """Return mu(t) of eqs. 14 and 15 at the samples of a result, from its mu_1, mu_2, grad z.

    mu_2 stands for the linearised mu_1 + mu'(v1) dv. ``time_below_one`` : see kinetic_law.py.
    """
    slope = dataset.rms_slope
    jump = slope * normalised_jump(dataset.mu_1 / slope) * dataset.velocity_step
    rate = xr.apply_ufunc(
        relaxation_rate,
        dataset.speed_ratio,
        dataset.hurst,
        kwargs={"time_below_one": time_below_one},
    )
    amplitude = dataset.mu_1 + jump - dataset.mu_2
    return dataset.mu_2 + amplitude * np.exp(-rate * dataset.time)


def law_error(dataset: xr.Dataset, time_below_one: bool = False) -> xr.DataArray:
    """Return the largest |law - simulated| / mu_1 over the recorded samples, per grid point."""
    difference = np.abs(law_curve(dataset, time_below_one) - dataset.mu)
    return (difference / np.abs(dataset.mu_1)).max("sample")


def shares_within(error: np.ndarray) -> list[float]:
    """Return the shares of points whose error is within 1, 5 and 20 %."""
    known = error[np.isfinite(error)]
    return [float(np.mean(known <= limit)) for limit in LIMITS]
