"""Meanings of what programmes of motion give: traces, energies, peaks, holds, loops, states."""

TRACE = {
    "trace_time": "The time since the start to which friction and forces belong.",
    "trace_distance": "The position X of the line since the start, growing as it slides forwards.",
    "trace_velocity": "The velocity v = dX/dt of the line.",
    "trace_segment": (
        "The number of the segment of the programme, from 0; repetitions count on. −1 is beyond "
        "the end of a programme that has fewer kept samples than another."
    ),
    "trace_mu": (
        "µ(t) = F_x/F_N, the mean over the lines. It is positive where the force on the line "
        "points backwards, so negative in sliding back."
    ),
    "trace_mu_change": (
        "µ(t) less its value at the last kept sample of the segment before. Its error is smaller "
        "than that of either."
    ),
    "trace_indentation_change": "The same of the indentation.",
    "trace_indentation": "d(t), with the sign of `indentation`.",
    "trace_normal_force": "F_N(t) = Σ f over the elements.",
    "trace_friction_force": "F_x(t) = Σ f z′ (eq. 5), with the sign of `trace_mu`.",
    "trace_drive_force": (
        "k (Y − X) + c (dY/dt − dX/dt), the force with which the drive pulls, where it does."
    ),
    "trace_contact_fraction": "The share of the line whose elements carry a force.",
    "trace_samples_per_contact": "`samples_per_contact` at each moment of the march.",
    "trace_resolution_status": (
        "That of the moment with the narrowest contacts; coarse where `trace_mu_bias` is above "
        "0.02."
    ),
    "trace_mu_bias": (
        "The rms error of µ(t) over its rms, at most: what the march has at its start in place of "
        "µ₁, together with 0.5/m², or the bias of µ₁ of measured lines. NaN where the trace does "
        "not start with steady sliding or `steady` was not asked for; 0.5/m² alone then counts in "
        "the status."
    ),
}
EVENTS = {
    "drive_swing": (
        "The greatest less the least force of the drive over F_N, in the second half of the last "
        "segment of each line; the mean over the lines. Steady sliding has none."
    ),
    "slip_period": (
        "The mean time between slips there. A slip begins where the line becomes twice as fast as "
        "the drive after it has stuck, which is to be less than half as fast, either way, for "
        "longer than half a free swing of the mass, π √(M/k), and than the drive takes from sample "
        "to sample: a mass that rings about steady sliding does not stick. It is NaN where a line "
        "slips less than twice."
    ),
    "peak_velocity": "The highest velocity of the line there.",
    "slip_event_time": (
        "When slips of one line begin and end and when it turns back, over the whole programme; "
        "the first 1000. A slip ends where the next stick begins."
    ),
    "slip_event_kind": "0: a slip begins, 1: it ends, 2: the velocity changes its sign.",
    "peak": (
        "The largest µ − µ₁ in the direction of the change after the last velocity step: the "
        "direct effect of an experiment where nothing jumps. It is negative after a step to a "
        "lower velocity."
    ),
    "peak_time": "The time from the velocity step to that peak.",
    "initial_rate": (
        "dµ/dt at t₀⁺ where there is no dashpot, so that µ itself is continuous. It is positive "
        "where the velocity grows."
    ),
    "static_peak": "The largest µ on sliding again after the last hold.",
    "healing": "That peak less µ before the last hold.",
    "mu_end_of_hold": (
        "µ at the end of the last hold, in which friction decays at a fixed position."
    ),
    "peak_distance": "The distance slid from the end of the hold to the static peak.",
    "loop_work": "∮ F_x dX over the last cycle of the last oscillation.",
    "mu_in_phase": (
        "µ′ of µ = … + µ′ sin 2πft + µ″ cos 2πft in that cycle: the elastic response, in phase "
        "with the displacement and proportional to G′ − G at small amplitudes."
    ),
    "mu_quadrature": (
        "µ″ of the same: the viscous response, in phase with the velocity and proportional to G″."
    ),
    "mu_cycle_mean": (
        "∫ F_x dt/∫ F_N dt of each line over the later half of the cycles of the last oscillation, "
        "from all steps, kept or not; the mean over the lines. Under a given normal force it is "
        "the mean of µ over time. Coulomb's law of friction, with one µ, makes it (2/π) asin(v/v̂) "
        "times µ where the mean velocity v is below the amplitude v̂ of the velocity, else µ."
    ),
    "mu_cycle_share": (
        "`mu_cycle_mean` over µ₁, where `steady` is asked for too. Lines scatter together, so that "
        "its error is smaller than that of either."
    ),
}
ENERGY = {
    "stored_energy": "The elastic energy of all elements, free ones too.",
    "dissipated_energy": "What dashpots and branches have dissipated since the start.",
    "work": "∫ F_x dX + ∫ F_N dd since the start.",
    "closing_work": (
        "The work, since the start, of pressing over gaps that close within a time step. It is an "
        "error of discretisation, of first order in the step for Kelvin elements, else of second."
    ),
    "balance_residual": (
        "(work − change of stored energy − dissipated energy − closing work)/dissipated energy at "
        "the end: 0 but for rounding and discretisation."
    ),
    "contact_length": (
        "How many patches of contact per line have a length within the bin, in multiples of Δx."
    ),
}
RATE_STATE = {
    "rate_state_a": (
        "a of µ = µ* + a ln(v/v*) + b ln(v* θ/D_c), by the law of the state θ that the coordinate "
        "`law` names, from b and (µ₂ − µ₁)/ln(v₂/v₁) = a − b."
    ),
    "rate_state_b": (
        "b of the same, which is not that of eq. 6. It is fitted to µ − µ₂ over the distance s "
        "since the step, from the largest value until 5 % of it, with r = v₂/v₁: b ln r "
        "exp(−s/D_c) by Ruina, b ln(1 + (r − 1) exp(−s/D_c)) by Dieterich. It is positive where "
        "friction falls back after its direct effect."
    ),
    "rate_state_a_minus_b": (
        "(µ₂ − µ₁)/ln(v₂/v₁), whatever the law. It is negative where steady friction falls with "
        "velocity."
    ),
    "rate_state_dc": "The critical distance D_c of the same fit.",
    "rate_state_residual": "Its rms residual over |b ln r|.",
    "rate_state_status": "Whether the law could be fitted, and if not, why.",
}
ALONE = {
    "snapshot_height": "z − d of the line, over the undeformed surface of the elastomer.",
    "snapshot_pressure": "The map of pressure on a half-space, whose samples stand still.",
    "snapshot_displacement": (
        "u of the elements, negative where they are pressed down; equal to `snapshot_height` in "
        "contact."
    ),
    "state_memory": "Internal variables of the elements, from which a run can go on.",
    "state_p": "Their dimensionless pressures.",
    "state_d": "The indentation over the lowest point of the line, over h.",
    "state_position": "The position of the line, in samples.",
    "state_time": "The time at which the run ended, in τ.",
    "state_speed": "The dimensionless speed v τ/Δx before the next segment.",
}
