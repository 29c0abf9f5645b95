"""Every variable of a result file, declared once: dims, units, meaning, how it scales."""

from typing import NamedTuple

import numpy as np

from workflow.reduce import ACCURACY_MEANINGS, MODEL_MEANINGS, STATUS_COMMENT, STATUS_MEANINGS
from workflow.study import AXES

GRID = AXES
CURVE = (*AXES, "sample")
PER_HURST = ("hurst",)

SLOPE, HEIGHT, PLAIN = "slope", "height", "plain"  # times h/dx, times h, as it is

ERRORS = "value +- t * error, t of Student with degrees_of_freedom, is an interval of confidence"


class Variable(NamedTuple):
    """Declaration of one variable."""

    dims: tuple[str, ...]
    units: str
    long_name: str
    scaling: str = PLAIN
    comment: str = ""


AXIS_ATTRIBUTES = {
    "hurst": ("1", "Hurst exponent H"),
    "normal_force": ("N", "normal force F_N"),
    "spacing": ("m", "element spacing dx"),
    "roughness": ("m", "rms roughness h"),
    "velocity": ("m s-1", "sliding velocity v1 before the jump"),
    "velocity_step": ("1", "relative velocity jump dv/v1"),
    "sample": ("1", "sample of the relaxation curve; 0 is just after the jump"),
}

VARIABLES: dict[str, Variable] = {
    "mu_1": Variable(GRID, "1", "steady coefficient of friction at v1", SLOPE),
    "mu_2": Variable(GRID, "1", "steady coefficient of friction at v2", SLOPE),
    "indentation": Variable(GRID, "m", "steady indentation d at v1", HEIGHT),
    "contact_fraction": Variable(GRID, "1", "share of the line in contact at v1"),
    "jump": Variable(GRID, "1", "instantaneous jump of the coefficient of friction", SLOPE),
    "relaxation_rate": Variable(
        GRID, "1", "relaxation rate b of eq. 6, per tau", comment="fit with mu_2 known"
    ),
    "relaxation_rate_free": Variable(
        GRID,
        "1",
        "relaxation rate b of eq. 6, per tau",
        comment="fit with mu_2 free; NaN where the window does not determine rate and offset both",
    ),
    "amplitude": Variable(GRID, "1", "amplitude mu* of eq. 6, with mu_2 known", SLOPE),
    "fit_status": Variable(GRID, "1", "outcome of the fit of eq. 6", comment=STATUS_COMMENT),
    "fit_window": Variable(
        GRID, "1", "end of the fit window in tau", comment="starts at the first step after the jump"
    ),
    "fit_quality": Variable(
        GRID, "1", "1 - residual / total sum of squares of mu - mu_2 in the fit window"
    ),
    "best_model": Variable(GRID, "1", "model that predicts left-out blocks best"),
    "stretched_rate": Variable(GRID, "1", "rate b of A exp(-(b t)^beta), per tau"),
    "stretched_exponent": Variable(GRID, "1", "exponent beta of A exp(-(b t)^beta)"),
    "fast_rate": Variable(GRID, "1", "faster rate of two exponentials, per tau"),
    "slow_rate": Variable(GRID, "1", "slower rate of two exponentials, per tau"),
    "fast_share": Variable(GRID, "1", "share of the faster exponential in the amplitude"),
    "gain_stretched": Variable(
        GRID, "1", "squared prediction error that a stretched exponential saves against eq. 6"
    ),
    "gain_two_exponentials": Variable(
        GRID, "1", "squared prediction error that two exponentials save against eq. 6"
    ),
    "deviation": Variable(CURVE, "1", "mu - mu_2 after the jump", SLOPE),
    "mu": Variable(CURVE, "1", "coefficient of friction after the jump", SLOPE),
    "time": Variable(CURVE, "1", "time since the jump, (t - t0)/tau"),
    "rms_slope": Variable(GRID, "1", "spectral rms slope of the line", SLOPE),
    "speed_ratio": Variable(GRID, "1", "x = v1 tau q_max"),
    "realizations": Variable(
        GRID, "1", "number of realizations averaged", comment="0: the computation failed"
    ),
    "steps_per_spacing": Variable(GRID, "1", "steps, and elements, per spacing dx"),
    "accuracy_reached": Variable(
        GRID,
        "1",
        "relative standard error plus bound of the discretisation error, the largest of what was "
        "asked for",
        comment="inf: not known; NaN: nothing that was asked for has a relative error here",
    ),
    "accuracy_status": Variable(GRID, "1", "whether numerics.accuracy was met"),
    "bias_bound": Variable(
        GRID, "1", "bound of the relative discretisation error, the largest of what was asked for"
    ),
    "alpha": Variable(
        PER_HURST, "1", "exponent of eq. 13, b = x^alpha, over fitted points with x > 1"
    ),
    "alpha_free": Variable(PER_HURST, "1", "exponent of b = c x^alpha over the same points"),
    "alpha_prefactor": Variable(PER_HURST, "1", "prefactor c of b = c x^alpha"),
    "alpha_scatter": Variable(PER_HURST, "1", "rms of log10(b / x^alpha)"),
    "alpha_points": Variable(PER_HURST, "1", "number of points in the fit of eq. 13"),
}

FLAGS = {
    "accuracy_status": ACCURACY_MEANINGS,
    "fit_status": STATUS_MEANINGS,
    "best_model": MODEL_MEANINGS,
}


def declared(name: str) -> Variable:
    """Return the declaration of a variable, or of the estimate NAME for NAME_error."""
    if name in VARIABLES:
        return VARIABLES[name]
    variable = VARIABLES[name.removesuffix("_error")]
    return variable._replace(long_name=f"standard error of {variable.long_name}", comment=ERRORS)


def attributes(name: str) -> dict[str, object]:
    """Return the CF-style attributes of a variable."""
    variable = declared(name)
    found: dict[str, object] = {"units": variable.units, "long_name": variable.long_name}
    if variable.comment:
        found["comment"] = variable.comment
    if name in FLAGS:
        meanings = FLAGS[name]
        flags = np.arange(len(meanings.split()), dtype=np.int8)
        found |= {"flag_values": flags, "flag_meanings": meanings}
    return found
