"""Every variable of a result file, declared once: meaning, how it scales, units, dims."""

import numpy as np

from ..reduce import (
    ACCURACY_MEANINGS,
    MODEL_MEANINGS,
    RESOLUTION_COMMENT,
    RESOLUTION_MEANINGS,
    STATUS_COMMENT,
    STATUS_MEANINGS,
)
from ..study import EVERY_AXIS
from .declaration import (
    BIAS,
    COUNT,
    CURVE,
    ERRORS,
    FLAG,
    HEIGHT,
    PER_HURST,
    SIGN_OF_D,
    SLOPE,
    Variable,
)
from .scenes import SCENES

AXIS_ATTRIBUTES = {row.name: (row.unit, row.long_name) for row in EVERY_AXIS.values()} | {
    "event": ("1", "sample of a trace; 0 is the start"),
    "bin": ("1", "lower edge of a bin of contact lengths, in spacings"),
    "law": ("1", "law of the state"),
    "wave_number": ("m-1", "wave number q of the line"),
    "x": ("m", "place along the foundation"),
    "unit": ("1", "internal variable of an element"),
    "sample": ("1", "sample of the relaxation curve; 0 is just after the jump"),
}

VARIABLES = {
    "mu_1": Variable("steady coefficient of friction at v1", SLOPE),
    "mu_2": Variable("steady coefficient of friction at v2", SLOPE),
    "indentation": Variable("steady indentation d at v1", HEIGHT, "m", comment=SIGN_OF_D),
    "contact_fraction": Variable("share of the line in contact at v1"),
    "jump": Variable("instantaneous jump of the coefficient of friction", SLOPE),
    "relaxation_rate": Variable(
        "relaxation rate b of eq. 6, per tau", comment="fit with mu_2 known"
    ),
    "relaxation_rate_free": Variable(
        "relaxation rate b of eq. 6, per tau",
        comment="fit with mu_2 free; NaN where the window does not determine rate and offset both",
    ),
    "amplitude": Variable("amplitude mu* of eq. 6, with mu_2 known", SLOPE),
    "fit_status": Variable("outcome of the fit of eq. 6", comment=STATUS_COMMENT, dtype=FLAG),
    "fit_window": Variable(
        "end of the fit window in tau", comment="starts at the first step after the jump"
    ),
    "fit_quality": Variable("1 - residual / total sum of squares of mu - mu_2 in the fit window"),
    "best_model": Variable("model that predicts left-out blocks best", dtype=FLAG),
    "stretched_rate": Variable("rate b of A exp(-(b t)^beta), per tau"),
    "stretched_exponent": Variable("exponent beta of A exp(-(b t)^beta)"),
    "fast_rate": Variable("faster rate of two exponentials, per tau"),
    "slow_rate": Variable("slower rate of two exponentials, per tau"),
    "fast_share": Variable("share of the faster exponential in the amplitude"),
    "gain_stretched": Variable(
        "squared prediction error that a stretched exponential saves against eq. 6"
    ),
    "gain_two_exponentials": Variable(
        "squared prediction error that two exponentials save against eq. 6"
    ),
    "deviation": Variable("mu - mu_2 after the jump", SLOPE, dims=CURVE),
    "mu": Variable("coefficient of friction after the jump", SLOPE, dims=CURVE),
    "time": Variable("time since the jump, (t - t0)/tau", dims=CURVE),
    "time_s": Variable("time since the jump, t - t0", units="s", dims=CURVE, dtype="float32"),
    "shear_modulus": Variable("relaxed shear modulus G", units="Pa", dims=()),
    "length": Variable("length L of the line, one period", units="m", dims=()),
    "q_max": Variable("largest wave number q_max of the line", units="m-1", dims=("spacing",)),
    "rms_slope": Variable("spectral rms slope of the line", SLOPE),
    "speed_ratio": Variable("x = v1 tau q_max"),
    "realizations": Variable(
        "number of realizations averaged", comment="0: the computation failed", dtype=COUNT
    ),
    "degrees_of_freedom": Variable(
        "degrees of freedom of the standard errors", comment="groups of blocks - 1", dtype=COUNT
    ),
    "steps_per_spacing": Variable("steps, and elements, per spacing dx", dtype=COUNT),
    "accuracy_reached": Variable(
        "relative standard error plus bound of the discretisation error, the largest of what was "
        "asked for",
        comment="inf: not known; NaN: nothing that was asked for has a relative error here",
    ),
    "accuracy_status": Variable("whether numerics.accuracy was met", dtype=FLAG),
    "bias_bound": Variable(
        "bound of the relative discretisation error, the largest of what was asked for",
        comment=BIAS,
    ),
    "samples_per_contact": Variable(
        "samples per patch of contact at v1, median over the load",
        comment="of the march; of the samples that friction rests on where nothing is marched",
    ),
    "resolution_status": Variable(
        "whether contacts are resolved", comment=RESOLUTION_COMMENT, dtype=FLAG
    ),
    "alpha": Variable(
        "exponent of eq. 13, b = x^alpha, over fitted points with x > 1", dims=PER_HURST
    ),
    "alpha_free": Variable("exponent of b = c x^alpha over the same points", dims=PER_HURST),
    "alpha_prefactor": Variable("prefactor c of b = c x^alpha", dims=PER_HURST),
    "alpha_scatter": Variable("rms of log10(b / x^alpha)", dims=PER_HURST),
    "alpha_bias": Variable(
        "what the bias of b may add to alpha, all points off in one direction", dims=PER_HURST
    ),
    "alpha_free_bias": Variable(
        "what the bias of b may add to alpha_free, fast and slow points off in opposite directions",
        dims=PER_HURST,
    ),
    "alpha_unresolved": Variable(
        "number of fitted points with x > 1 left out of the fit of eq. 13, as unresolved",
        dims=PER_HURST,
        dtype=COUNT,
    ),
    "alpha_points": Variable("number of points in the fit of eq. 13", dims=PER_HURST, dtype=COUNT),
}

VARIABLES |= SCENES

# Coordinates beside those of the dimensions: in what a value can be drawn or looked up.
AUXILIARY = (
    "tau",
    "shear_modulus",
    "length",
    "q_max",
    "speed_ratio",
    "time",
    "time_s",
    "trace_time",
    "trace_distance",
)

FLAGS = {
    "rate_state_status": STATUS_MEANINGS,
    "accuracy_status": ACCURACY_MEANINGS,
    "fit_status": STATUS_MEANINGS,
    "resolution_status": RESOLUTION_MEANINGS,
    "best_model": MODEL_MEANINGS,
}


def declared(name: str) -> Variable:
    """Return the declaration of a variable, or of the estimate NAME for NAME_error, NAME_bias."""
    if name in VARIABLES:
        return VARIABLES[name]
    if name.endswith("_bias"):
        of = VARIABLES[name.removesuffix("_bias")].long_name
        return Variable(f"bound of the relative discretisation error of {of}", comment=BIAS)
    variable = VARIABLES[name.removesuffix("_error")]
    return variable._replace(long_name=f"standard error of {variable.long_name}", comment=ERRORS)


def attributes(name: str) -> dict[str, object]:
    """Return the CF-style attributes of a variable."""
    variable = declared(name)
    found: dict[str, object] = {"units": variable.units, "long_name": variable.long_name}
    if variable.comment:
        found["comment"] = variable.comment
    if name in FLAGS:
        meanings = f"failed {FLAGS[name]}"  # -1: the computation did
        flags = np.arange(len(meanings.split()), dtype=FLAG) - np.int8(1)
        found |= {"flag_values": flags, "flag_meanings": meanings}
    return found
