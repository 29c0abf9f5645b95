"""Meanings of what programmes of motion give: traces, energies, peaks, holds, loops, states."""

from .meaning import Meaning

LAST_STEP = "after the last velocity step of the programme, or the velocity step of the grid"
OF_MOTION = "Positive where the line slides forwards."
TRACE = {
    "trace_time": Meaning(
        "The time to which friction and forces belong, from the start of the programme."
    ),
    "trace_distance": Meaning("The position X of the line since the start.", OF_MOTION),
    "trace_velocity": Meaning("The velocity v = dX/dt of the line.", OF_MOTION),
    "trace_segment": Meaning(
        "The number of the segment of the programme, from 0; repetitions count on. −1 is beyond "
        "the end of a programme that has fewer kept samples than another."
    ),
    "trace_mu": Meaning(
        "µ(t) = F_x/F_N along the programme, the mean over the lines.",
        "Positive where the force on the line points backwards, so negative in sliding back.",
    ),
    "trace_mu_change": Meaning(
        "µ(t) less its value at the last kept sample of the segment before. Its error is that of "
        "the difference, which is smaller than that of either value."
    ),
    "trace_indentation_change": Meaning("The same of the indentation.", "As of `indentation`."),
    "trace_indentation": Meaning(
        "d(t), by which the mean line lies below the undeformed surface.", "As of `indentation`."
    ),
    "trace_normal_force": Meaning(
        "F_N(t) = Σ f over the elements; constant where the force is controlled."
    ),
    "trace_friction_force": Meaning("F_x(t) = Σ f z′ (eq. 5).", "As of `trace_mu`."),
    "trace_contact_fraction": Meaning("The share of the line whose elements carry a force."),
}
EVENTS = {
    "peak": Meaning(
        f"The largest µ − µ₁ in the direction of the change, {LAST_STEP}: what an experiment "
        "calls the direct effect where nothing jumps.",
        "Negative after a step to a lower velocity.",
    ),
    "peak_time": Meaning("The time from the velocity step to that peak."),
    "initial_rate": Meaning(
        "dµ/dt at t₀⁺, where there is no dashpot and µ itself is continuous.",
        "Positive where the velocity grows.",
    ),
    "static_peak": Meaning("The largest µ on sliding again after the last hold."),
    "healing": Meaning("The static peak less µ before the last hold."),
    "mu_end_of_hold": Meaning(
        "µ at the end of the last hold, during which friction decays at a fixed position."
    ),
    "peak_distance": Meaning("The distance slid from the end of the hold to the static peak."),
    "loop_work": Meaning("∮ F_x dX over the last cycle of the last oscillation."),
    "mu_in_phase": Meaning(
        "µ′ of µ = … + µ′ sin 2πft + µ″ cos 2πft in the last cycle: the elastic response, "
        "proportional to G′ − G for small amplitudes."
    ),
    "mu_quadrature": Meaning("µ″ of the same: the viscous response, proportional to G″."),
}
ENERGY = {
    "stored_energy": Meaning("The elastic energy of all elements, free ones too."),
    "dissipated_energy": Meaning("What dashpots and branches have dissipated since the start."),
    "work": Meaning("∫ F_x dX + ∫ F_N dd since the start."),
    "closing_work": Meaning(
        "The work of pressing over gaps that close within a time step. It is an error of "
        "discretisation: for Kelvin elements of first order in the step, else of second."
    ),
    "balance_residual": Meaning(
        "(work − change of stored energy − dissipated energy − closing work)/dissipated energy at "
        "the end of the programme; 0 but for rounding and discretisation."
    ),
    "contact_length": Meaning(
        "How many patches of contact per line have a length within the bin, in multiples of Δx."
    ),
}
RATE_STATE = {
    "rate_state_a": Meaning(
        "a of µ = µ* + a ln(v/v*) + b ln(v* θ/D_c), from b and (µ₂ − µ₁)/ln(v₂/v₁) = a − b, by "
        "the law of the state θ that the coordinate `law` names."
    ),
    "rate_state_b": Meaning(
        "b of the same, fitted to µ − µ₂ over the distance s since the step: b ln r exp(−s/D_c) by "
        "Ruina's law, b ln(1 + (r − 1) exp(−s/D_c)) by Dieterich's, r = v₂/v₁.",
        "Positive where friction falls back after its direct effect. It is not the `b` of eq. 6.",
    ),
    "rate_state_a_minus_b": Meaning(
        "(µ₂ − µ₁)/ln(v₂/v₁), whatever the law.", "Negative: steady friction falls with velocity."
    ),
    "rate_state_dc": Meaning("The critical distance D_c of the same fit."),
    "rate_state_residual": Meaning("The rms residual of the fit over |b ln r|."),
    "rate_state_status": Meaning("Whether the law could be fitted, and if not, why."),
}
ALONE = {
    "snapshot_height": Meaning(
        "z − d of the line, over the undeformed surface of the elastomer.",
        "Negative where the line lies below that surface.",
    ),
    "snapshot_displacement": Meaning(
        "u of the elements; equal to `snapshot_height` in contact.", "Negative: pressed down."
    ),
    "state_memory": Meaning("Internal variables of the elements, from which a run can go on."),
    "state_p": Meaning("Pressures of the elements, dimensionless, from which a run can go on."),
    "state_d": Meaning("The indentation over the lowest point of the line, over h."),
    "state_position": Meaning("The position of the line, in samples."),
    "state_time": Meaning("The time at which the run ended, in τ."),
    "state_speed": Meaning("The dimensionless speed v τ/Δx before the next segment."),
}
