"""Declarations of all variables of a result file: meaning, scaling, units and dimensions."""

from typing import NamedTuple

import numpy as np

from ..reduce import (
    ACCURACY_MEANINGS,
    MODEL_MEANINGS,
    RESOLUTION_COMMENT,
    RESOLUTION_MEANINGS,
    STATUS_COMMENT,
    STATUS_MEANINGS,
)
from ..study import ALL_AXES, COMMON_AXES

Powers = dict[str, int]  # of grid axes, tau, E* ("modulus") and E* L ("stiffness")


class Scaling(NamedTuple):
    """Unit of a variable, and the powers that scale its dimensionless value to that unit."""

    units: str
    powers: Powers = {}  # noqa: RUF012 - never changed


DIMENSIONLESS, CELSIUS = Scaling("1"), Scaling("degree_Celsius")
SLOPE = Scaling("1", {"roughness": 1, "spacing": -1})
HEIGHT, LENGTH = Scaling("m", {"roughness": 1}), Scaling("m", {"spacing": 1})
DURATION, SPEED = Scaling("s", {"tau": 1}), Scaling("m s-1", {"spacing": 1, "tau": -1})
RATE = Scaling("s-1", {"roughness": 1, "spacing": -1, "tau": -1})
PRESSURE = Scaling("Pa", {"modulus": 1, "roughness": 1, "spacing": -1})
NORMAL_FORCE = Scaling("N", {"stiffness": 1, "roughness": 1})
FRICTION_FORCE = Scaling("N", {"stiffness": 1, "roughness": 2, "spacing": -1})
ENERGY = Scaling("J", {"stiffness": 1, "roughness": 2})

GRID_DIMS, HURST_DIMS = COMMON_AXES, ("hurst",)
CURVE_DIMS = (*GRID_DIMS, "sample")
EVENT_DIMS = (*GRID_DIMS, "event")
SLIP_EVENT_DIMS = (*GRID_DIMS, "slip_event")
LAW_DIMS = (*GRID_DIMS, "law")
FRAME_DIMS = (*GRID_DIMS, "event", "x")
STATE_DIMS = (*GRID_DIMS, "x")
FLAG_DTYPE, COUNT_DTYPE = "int8", "int32"

ERROR_COMMENT = (
    "value +- t * error is a confidence interval, with Student's t for degrees_of_freedom"
)
SIGN_OF_D = (
    "positive if the mean line lies below the undeformed surface of the elastomer; negative "
    "at light loads"
)
BIAS_COMMENT = (
    "9 in 10 problems are within it (docs/accuracy.md); not part of the standard error; NaN: "
    "unknown, for materials with branches, programmes, prescribed indentation, and a rate with "
    "shear"
)
SHEAR_COMMENT = (
    "the real contact area falls as 1/rms_slope, which depends on the shortest wave, 2 pi/q_max"
)


class Variable(NamedTuple):
    """Declaration of one variable."""

    long_name: str
    scaling: Scaling = DIMENSIONLESS
    dims: tuple[str, ...] = GRID_DIMS
    comment: str = ""
    dtype: str = "float64"


AXIS_ATTRIBUTES = {row.name: (row.unit, row.long_name) for row in ALL_AXES.values()} | {
    "normal_pressure": ("Pa", "nominal pressure that the normal force stands for"),
    "event": ("1", "sample of a trace; 0 is the start"),
    "bin": ("1", "lower edge of a bin of contact lengths, in spacings"),
    "law": ("1", "law of the state"),
    "wave_number": ("m-1", "wave number q of the line"),
    "x": ("m", "place along the foundation, or the half-space"),
    "y": ("m", "place across the half-space"),
    "unit": ("1", "internal variable of an element"),
    "sample": ("1", "sample of the relaxation curve; 0 is just after the jump"),
}

VARIABLES = {
    "mu_1": Variable("steady coefficient of friction at v1", SLOPE),
    "mu_2": Variable("steady coefficient of friction at v2", SLOPE),
    "indentation": Variable("steady indentation d at v1", HEIGHT, comment=SIGN_OF_D),
    "contact_fraction": Variable("share of the line in contact at v1"),
    "contact_temperature": Variable(
        "temperature of the contact at v1",
        CELSIUS,
        comment="of the surface of the rubber, mean weighted with the pressure",
    ),
    "flash_temperature": Variable(
        "highest temperature of the surface of the rubber at v1", CELSIUS
    ),
    "mean_contact_pressure": Variable(
        "normal force over the real contact area at v1",
        Scaling("Pa"),
        comment="of a half-space; absent on a foundation, whose contact is a share of a line",
    ),
    "mu_persson": Variable("coefficient of friction at v1 by Persson's theory", SLOPE),
    "area_persson": Variable("real contact area at v1 by Persson's theory, over the nominal one"),
    "model_ratio": Variable(
        "mu_1 of the foundation over that of a half-space",
        comment="at the same nominal pressure: the error of the model. The attribute "
        "model_ratio_source names its source",
    ),
    "model_realizations": Variable(
        "number of realizations of the other body in model_ratio", dtype=COUNT_DTYPE
    ),
    "mu_persson_shear": Variable(
        "shear of area_persson over the normal force at v1", SLOPE, comment=SHEAR_COMMENT
    ),
    "mu_persson_total": Variable("mu_persson + mu_persson_shear", SLOPE),
    "jump": Variable("instantaneous jump of the coefficient of friction", SLOPE),
    "relaxation_rate": Variable(
        "relaxation rate b of eq. 6, per tau", comment="fit with mu_2 known"
    ),
    "relaxation_rate_free": Variable(
        "relaxation rate b of eq. 6, per tau",
        comment="fit with mu_2 free; NaN if the window does not determine both rate and offset",
    ),
    "amplitude": Variable("amplitude mu* of eq. 6, with mu_2 known", SLOPE),
    "fit_status": Variable("outcome of the fit of eq. 6", comment=STATUS_COMMENT, dtype=FLAG_DTYPE),
    "fit_window": Variable(
        "end of the fit window in tau", comment="starts at the first step after the jump"
    ),
    "fit_quality": Variable("1 - residual / total sum of squares of mu - mu_2 in the fit window"),
    "best_model": Variable("model that predicts left-out blocks best", dtype=FLAG_DTYPE),
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
    "deviation": Variable("mu - mu_2 after the jump", SLOPE, CURVE_DIMS),
    "mu": Variable("coefficient of friction after the jump", SLOPE, CURVE_DIMS),
    "time": Variable("time since the jump, (t - t0)/tau", dims=CURVE_DIMS),
    "time_s": Variable("time since the jump, t - t0", Scaling("s"), CURVE_DIMS, dtype="float32"),
    "shear_modulus": Variable("relaxed shear modulus G", Scaling("Pa"), ()),
    "length": Variable("length L of the line, one period", Scaling("m"), ()),
    "q_max": Variable("largest wave number q_max of the line", Scaling("m-1"), ("spacing",)),
    "rms_slope": Variable("spectral rms slope of the line", SLOPE),
    "speed_ratio": Variable("x = v1 tau q_max"),
    "realizations": Variable(
        "number of realizations averaged", comment="0: the computation failed", dtype=COUNT_DTYPE
    ),
    "degrees_of_freedom": Variable(
        "degrees of freedom of the standard errors",
        comment="groups of blocks, or tiles of a single map, less one",
        dtype=COUNT_DTYPE,
    ),
    "steps_per_spacing": Variable("steps, and elements, per spacing dx", dtype=COUNT_DTYPE),
    "accuracy_reached": Variable(
        "relative standard error plus bound of the discretisation error, maximum of the "
        "requested quantities",
        comment="inf: unknown; NaN: no requested quantity has a relative error",
    ),
    "accuracy_status": Variable("whether numerics.accuracy was met", dtype=FLAG_DTYPE),
    "bias_bound": Variable(
        "bound of the relative discretisation error, maximum of the requested quantities",
        comment=BIAS_COMMENT,
    ),
    "samples_per_contact": Variable(
        "samples per contact patch at v1, median over the load",
        comment="during the march, or in steady sliding without a march",
    ),
    "resolution_status": Variable(
        "whether contacts are resolved", comment=RESOLUTION_COMMENT, dtype=FLAG_DTYPE
    ),
    "alpha": Variable(
        "exponent of eq. 13, b = x^alpha, over fitted points with x > 1", dims=HURST_DIMS
    ),
    "alpha_free": Variable("exponent of b = c x^alpha over the same points", dims=HURST_DIMS),
    "alpha_prefactor": Variable("prefactor c of b = c x^alpha", dims=HURST_DIMS),
    "alpha_scatter": Variable("rms of log10(b / x^alpha)", dims=HURST_DIMS),
    "alpha_bias": Variable("largest change of alpha by biases of b of equal sign", dims=HURST_DIMS),
    "alpha_free_bias": Variable(
        "largest change of alpha_free by biases of b of opposite sign at fast and slow points",
        dims=HURST_DIMS,
    ),
    "alpha_unresolved": Variable(
        "number of unresolved points with x > 1 left out of the fit of eq. 13",
        dims=HURST_DIMS,
        dtype=COUNT_DTYPE,
    ),
    "alpha_points": Variable(
        "number of points in the fit of eq. 13", dims=HURST_DIMS, dtype=COUNT_DTYPE
    ),
}

# Variables of programmes of motion and of materials with branches.
SLIP_COMMENT = "of the second half of the last segment; the mean over the lines"
SLIP_STATUS_COMMENT = (
    "of a single line or map: a drive with slips is repeated with heights larger by 0.5/m^2; "
    "unresolved: a quantity changes by more than 4 times that, and by more than 2 % (map 5 %); "
    "several lines have standard errors instead"
)
TRACE_COMMENT = "as resolution_status, for the narrowest contacts and trace_mu_bias"
CHANGE_COMMENT = "since the last recorded sample of the previous segment"
NO_STATE_COMMENT = (
    "mu = mu* + a ln(v/v*) + b ln(v* theta/D_c); b and D_c from mu - mu_2 after the velocity step, "
    "from its largest value until it has fallen to 5 %, with mu_2 known; (a - b) ln r = mu_2 - mu_1"
)

SCENES = {
    "tau": Variable("time scale: relaxation_time + sum g_b t_b/G", Scaling("s")),
    "power_spectrum": Variable("power spectrum C_1D of the lines", Scaling("m3"), ("wave_number",)),
    "trace_time": Variable("time to which the friction belongs", DURATION, EVENT_DIMS),
    "trace_distance": Variable("position of the line", LENGTH, EVENT_DIMS),
    "trace_velocity": Variable("velocity of the line", SPEED, EVENT_DIMS),
    "trace_segment": Variable(
        "segment of the programme, from 0", dims=EVENT_DIMS, dtype=COUNT_DTYPE
    ),
    "trace_mu": Variable("coefficient of friction", SLOPE, EVENT_DIMS),
    "trace_mu_change": Variable(
        "change of mu in the segment of the programme", SLOPE, EVENT_DIMS, comment=CHANGE_COMMENT
    ),
    "trace_indentation_change": Variable(
        "change of the indentation in the segment of the programme",
        HEIGHT,
        EVENT_DIMS,
        comment=CHANGE_COMMENT,
    ),
    "trace_indentation": Variable(
        "indentation d over the mean line", HEIGHT, EVENT_DIMS, comment=SIGN_OF_D
    ),
    "trace_normal_force": Variable("normal force", NORMAL_FORCE, EVENT_DIMS),
    "trace_friction_force": Variable("friction force", FRICTION_FORCE, EVENT_DIMS),
    "trace_drive_force": Variable("force of the drive", FRICTION_FORCE, EVENT_DIMS),
    "trace_contact_temperature": Variable(
        "temperature of the contact in a step", CELSIUS, EVENT_DIMS
    ),
    "trace_flash_temperature": Variable(
        "highest temperature of the surface of the rubber", CELSIUS, EVENT_DIMS
    ),
    "trace_contact_fraction": Variable("share of the line in contact", dims=EVENT_DIMS),
    "trace_samples_per_contact": Variable(
        "samples per contact patch in the march, median over the load", dims=EVENT_DIMS
    ),
    "trace_resolution_status": Variable(
        "whether the contacts of a trace are resolved", comment=TRACE_COMMENT, dtype=FLAG_DTYPE
    ),
    "trace_mu_bias": Variable(
        "bound of the relative discretisation error of trace_mu, root mean square",
        comment="9 in 10 traces are within it; not part of the standard error; NaN: unknown, "
        "if the trace does not start with steady sliding or mu_1 was not requested",
    ),
    "trace_remembered": Variable(
        "share of the first contact that a branch still holds after one period",
        comment="0: the motion covers no period or starts with steady sliding; otherwise the "
        "trace repeats its first contact every period: take a longer line, or start "
        "steady",
    ),
    "drive_swing": Variable(
        "largest minus smallest force of the drive over F_N", SLOPE, comment=SLIP_COMMENT
    ),
    "slip_period": Variable(
        "period of stick and slip",
        DURATION,
        comment=f"{SLIP_COMMENT}; NaN: a line slips fewer than two times there",
    ),
    "peak_velocity": Variable("highest velocity of the line", SPEED, comment=SLIP_COMMENT),
    "slip_resolution_status": Variable(
        "whether the quantities of a drive are resolved",
        comment=SLIP_STATUS_COMMENT,
        dtype=FLAG_DTYPE,
    ),
    "slip_event_time": Variable("time of an event of the line", DURATION, SLIP_EVENT_DIMS),
    "slip_event_kind": Variable(
        "kind of an event of the line", dims=SLIP_EVENT_DIMS, dtype=FLAG_DTYPE
    ),
    "peak": Variable("largest mu - mu_1 after the velocity step, in its direction", SLOPE),
    "peak_time": Variable("time of the peak since the velocity step", DURATION),
    "initial_rate": Variable(
        "rate of mu just after the velocity step",
        RATE,
        comment="NaN with shear, as samples do not resolve the rate of the contact area",
    ),
    "static_peak": Variable("largest mu on sliding after the last hold", SLOPE),
    "healing": Variable("static peak minus mu before the last hold", SLOPE),
    "mu_end_of_hold": Variable("mu at the end of the last hold", SLOPE),
    "peak_distance": Variable("distance from the end of the hold to the peak", LENGTH),
    "loop_work": Variable("work of friction in the last cycle of an oscillation", ENERGY),
    "mu_in_phase": Variable("amplitude of mu in phase with the displacement", SLOPE),
    "mu_quadrature": Variable("amplitude of mu in phase with the velocity", SLOPE),
    "mu_cycle_mean": Variable(
        "mean friction over mean normal force in an oscillation",
        SLOPE,
        comment="over the second half of the cycles of the last oscillation; mean over the lines",
    ),
    "mu_cycle_share": Variable("mean friction in an oscillation over mu_1"),
    "stored_energy": Variable("energy stored in the foundation", ENERGY, EVENT_DIMS),
    "dissipated_energy": Variable("energy dissipated since the start", ENERGY, EVENT_DIMS),
    "work": Variable("work of friction and normal force since the start", ENERGY, EVENT_DIMS),
    "closing_work": Variable(
        "work N of closing gaps within a step since the start",
        ENERGY,
        EVENT_DIMS,
        comment="a discretisation error; for a Kelvin element 4 sum p g, with the previous gap g",
    ),
    "balance_residual": Variable(
        "(work - change of stored energy - dissipation - closing work)/dissipation",
        comment="with a drive: (work - friction - damper - step - change of stored)/work",
    ),
    "drive_work": Variable("work of the drive since the start", ENERGY, EVENT_DIMS),
    "friction_work": Variable("work of friction since the start", ENERGY, EVENT_DIMS),
    "spring_energy": Variable("energy of the drive's spring", ENERGY, EVENT_DIMS),
    "kinetic_energy": Variable("kinetic energy of the slider", ENERGY, EVENT_DIMS),
    "damper_work": Variable(
        "energy dissipated by the drive's damper since the start", ENERGY, EVENT_DIMS
    ),
    "step_work": Variable(
        "work of inertia beyond the change of the kinetic energy since the start",
        ENERGY,
        EVENT_DIMS,
        comment="a discretisation error of second order in the step; zero without a mass",
    ),
    "contact_length": Variable("mean number of contacts of a length", dims=(*GRID_DIMS, "bin")),
    "snapshot_height": Variable(
        "height of the line over the undeformed foundation", HEIGHT, FRAME_DIMS
    ),
    "snapshot_pressure": Variable(
        "pressure on a half-space", PRESSURE, (*GRID_DIMS, "event", "y", "x")
    ),
    "snapshot_displacement": Variable("displacement of the foundation", HEIGHT, FRAME_DIMS),
    "rate_state_a": Variable("a of rate and state", SLOPE, LAW_DIMS, comment=NO_STATE_COMMENT),
    "rate_state_b": Variable("b of rate and state", SLOPE, LAW_DIMS, comment=NO_STATE_COMMENT),
    "rate_state_a_minus_b": Variable(
        "a - b of rate and state", SLOPE, comment="(mu_2 - mu_1)/ln(v2/v1), for either law"
    ),
    "rate_state_dc": Variable("critical distance D_c", LENGTH, LAW_DIMS, comment=NO_STATE_COMMENT),
    "rate_state_residual": Variable("rms residual of the fit over |b ln r|", dims=LAW_DIMS),
    "rate_state_status": Variable(
        "outcome of the fit of rate and state",
        dims=LAW_DIMS,
        comment=STATUS_COMMENT,
        dtype=FLAG_DTYPE,
    ),
    "state_memory": Variable(
        "internal variables of the elements, dimensionless", dims=(*GRID_DIMS, "unit", "x")
    ),
    "state_p": Variable("pressures of the elements, dimensionless", dims=STATE_DIMS),
    "state_d": Variable("indentation above the lowest point of the line, over h"),
    "state_position": Variable("position of the line, in samples"),
    "state_time": Variable("time, in tau"),
    "state_speed": Variable("speed before the next segment, v tau/dx"),
}
VARIABLES |= SCENES

# Coordinates that are not dimensions, for the abscissa of plots.
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

PARTS = {"shear": "shear of the real contact in the", "viscoelastic": "viscoelastic part of the"}

FLAGS = {
    "slip_event_kind": "slip_begins slip_ends reversal",
    "rate_state_status": STATUS_MEANINGS,
    "accuracy_status": ACCURACY_MEANINGS,
    "fit_status": STATUS_MEANINGS,
    "resolution_status": RESOLUTION_MEANINGS,
    "trace_resolution_status": RESOLUTION_MEANINGS,
    "slip_resolution_status": RESOLUTION_MEANINGS,
    "best_model": MODEL_MEANINGS,
}


def declared(name: str) -> Variable:
    """Return the declaration of a variable.

    NAME_error, NAME_bias and the parts NAME_shear and NAME_viscoelastic derive from NAME.
    """
    if name in VARIABLES:
        return VARIABLES[name]
    total, _, part = name.rpartition("_")
    if part in PARTS and total in VARIABLES:
        variable = VARIABLES[total]
        comment = SHEAR_COMMENT if part == "shear" else variable.comment
        return variable._replace(long_name=f"{PARTS[part]} {variable.long_name}", comment=comment)
    if name.endswith("_bias"):
        quantity = VARIABLES[name.removesuffix("_bias")].long_name
        return Variable(
            f"bound of the relative discretisation error of {quantity}", comment=BIAS_COMMENT
        )
    variable = declared(total) if part == "error" else VARIABLES[name]
    return variable._replace(
        long_name=f"standard error of {variable.long_name}", comment=ERROR_COMMENT
    )


def attributes(name: str) -> dict[str, object]:
    """Return the CF-style attributes of a variable."""
    variable = declared(name)
    cf_attributes: dict[str, object] = {
        "units": variable.scaling.units,
        "long_name": variable.long_name,
    }
    if variable.comment:
        cf_attributes["comment"] = variable.comment
    if name in FLAGS:
        meanings = f"failed {FLAGS[name]}"  # -1: the computation failed
        flags = np.arange(len(meanings.split()), dtype=FLAG_DTYPE) - np.int8(1)
        cf_attributes |= {"flag_values": flags, "flag_meanings": meanings}
    return cf_attributes
