"""The variables of scenes: what a programme of motion, or another elastomer, adds to a result."""

from ..reduce import STATUS_COMMENT
from .declaration import COUNT, FLAG, GRID, HEIGHT, SIGN_OF_D, SLOPE, Variable

EVENT = (*GRID, "event")
LAW = (*GRID, "law")
BIN = (*GRID, "bin")
FRAME = (*GRID, "event", "x")
STATE = (*GRID, "x")
FORCE = {"stiffness": 1, "roughness": 1}
FRICTION = {"stiffness": 1, "roughness": 2, "spacing": -1}
ENERGY = {"stiffness": 1, "roughness": 2}
TIME, RATE = {"tau": 1}, {"roughness": 1, "spacing": -1, "tau": -1}
LENGTH, SPEED = {"spacing": 1}, {"spacing": 1, "tau": -1}

CHANGE_COMMENT = "since the last kept sample of the segment before"
NO_STATE_COMMENT = (
    "mu = mu* + a ln(v/v*) + b ln(v* theta/D_c); b and D_c from mu - mu_2 after the velocity step, "
    "from its largest value until it has fallen to 5 %, with mu_2 known; (a - b) ln r = mu_2 - mu_1"
)

SCENES = {
    "tau": Variable("time scale: relaxation_time + sum g_b t_b/G", units="s"),
    "power_spectrum": Variable(
        "power spectrum C_1D of the lines", units="m3", dims=("wave_number",)
    ),
    "trace_time": Variable("time to which the friction belongs", TIME, "s", EVENT),
    "trace_distance": Variable("position of the line", LENGTH, "m", EVENT),
    "trace_velocity": Variable("velocity of the line", SPEED, "m s-1", EVENT),
    "trace_segment": Variable("segment of the programme, from 0", dims=EVENT, dtype=COUNT),
    "trace_mu": Variable("coefficient of friction", SLOPE, dims=EVENT),
    "trace_mu_change": Variable(
        "change of mu in the segment of the programme", SLOPE, dims=EVENT, comment=CHANGE_COMMENT
    ),
    "trace_indentation_change": Variable(
        "change of the indentation in the segment of the programme",
        HEIGHT,
        "m",
        EVENT,
        comment=CHANGE_COMMENT,
    ),
    "trace_indentation": Variable(
        "indentation d over the mean line", HEIGHT, "m", EVENT, comment=SIGN_OF_D
    ),
    "trace_normal_force": Variable("normal force", FORCE, "N", EVENT),
    "trace_friction_force": Variable("friction force", FRICTION, "N", EVENT),
    "trace_contact_fraction": Variable("share of the line in contact", dims=EVENT),
    "peak": Variable("largest mu - mu_1 after the velocity step, in its direction", SLOPE),
    "peak_time": Variable("time of the peak since the velocity step", TIME, "s"),
    "initial_rate": Variable("rate of mu just after the velocity step", RATE, "s-1"),
    "static_peak": Variable("largest mu on sliding after the last hold", SLOPE),
    "healing": Variable("static peak over mu before the last hold", SLOPE),
    "mu_end_of_hold": Variable("mu at the end of the last hold", SLOPE),
    "peak_distance": Variable("distance from the end of the hold to the peak", LENGTH, "m"),
    "loop_work": Variable("work of friction in the last cycle of an oscillation", ENERGY, "J"),
    "mu_in_phase": Variable("amplitude of mu in phase with the displacement", SLOPE),
    "mu_quadrature": Variable("amplitude of mu in phase with the velocity", SLOPE),
    "stored_energy": Variable("energy stored in the foundation", ENERGY, "J", EVENT),
    "dissipated_energy": Variable("energy dissipated since the start", ENERGY, "J", EVENT),
    "work": Variable("work of friction and normal force since the start", ENERGY, "J", EVENT),
    "closing_work": Variable(
        "work N of closing gaps within a step since the start",
        ENERGY,
        "J",
        EVENT,
        comment="of the discretisation; for a Kelvin element 4 sum p g, g the gap before",
    ),
    "balance_residual": Variable(
        "work less the change of stored energy, dissipation and closing work, over dissipation"
    ),
    "contact_length": Variable("mean number of contacts of a length", dims=BIN),
    "snapshot_height": Variable(
        "height of the line over the undeformed foundation", HEIGHT, "m", FRAME
    ),
    "snapshot_displacement": Variable("displacement of the foundation", HEIGHT, "m", FRAME),
    "rate_state_a": Variable("a of rate and state", SLOPE, dims=LAW, comment=NO_STATE_COMMENT),
    "rate_state_b": Variable("b of rate and state", SLOPE, dims=LAW, comment=NO_STATE_COMMENT),
    "rate_state_a_minus_b": Variable(
        "a - b of rate and state", SLOPE, comment="(mu_2 - mu_1)/ln(v2/v1), whatever the law"
    ),
    "rate_state_dc": Variable("critical distance D_c", LENGTH, "m", LAW, comment=NO_STATE_COMMENT),
    "rate_state_residual": Variable("rms residual of the fit over |b ln r|", dims=LAW),
    "rate_state_status": Variable(
        "outcome of the fit of rate and state", dims=LAW, comment=STATUS_COMMENT, dtype=FLAG
    ),
    "state_memory": Variable(
        "internal variables of the elements, dimensionless", dims=(*GRID, "unit", "x")
    ),
    "state_p": Variable("pressures of the elements, dimensionless", dims=STATE),
    "state_d": Variable("indentation over the deepest point, in roughnesses"),
    "state_position": Variable("position of the line, in samples"),
    "state_time": Variable("time, in tau"),
    "state_speed": Variable("speed before the next segment, v tau/dx"),
}
