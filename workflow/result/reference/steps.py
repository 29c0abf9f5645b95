"""Meanings of what a velocity step gives: steady states, the jump, relaxation and its fits."""

STEADY = {
    "mu_1": (
        "µ₁ = F_x/F_N (eq. 5) in steady sliding at v₁, the mean over the lines. It is positive "
        "where friction opposes the sliding; a negative mean is noise or discretisation."
    ),
    "mu_2": "The same at v₂ = v₁ (1 + Δv/v₁).",
    "indentation": (
        "The indentation d of eq. 4 in steady sliding at v₁, by which the mean line lies below "
        "the undeformed surface of the elastomer: in contact the displacement is u = z − d. It is "
        "negative at light loads, where only peaks of the line touch."
    ),
    "contact_fraction": (
        "The share of the line, from 0 to 1, whose elements carry a force in steady sliding at v₁."
    ),
    "mu_persson": (
        "µ at v₁ by Persson's theory for a half-space with the spectrum of the study, asked for by "
        "the quantity `persson`. It is exact in full contact."
    ),
    "area_persson": "The share of the nominal area that is in contact by the same theory.",
    "model_ratio": (
        "µ₁ of the foundation over µ₁ of a half-space at the same nominal pressure, the error of "
        "the model, from a table made by the study `bodies`; NaN outside it, and left out where "
        "nothing is known of any point."
    ),
}
JUMP = {
    "jump": (
        "Δµ₀ = µ(t₀⁺) − µ₁ (eqs. 8 to 12): the displacements are unchanged, while the velocity "
        "and the rate of the indentation jump. It is positive where the velocity grows."
    ),
}
RELAXATION = {
    "relaxation_rate": (
        "b of µ − µ₂ = µ* exp(−b t̄), t̄ = (t − t₀)/τ (eqs. 6 and 7), with µ* and b fitted and µ₂ "
        "known from steady sliding. The relaxation time is τ/b. It is NaN unless `fit_status` is "
        "`fitted` or `negligible`."
    ),
    "relaxation_rate_free": (
        "The same with µ₂ fitted too; NaN where the window does not determine both."
    ),
    "amplitude": (
        "µ* of eq. 6, which eq. 8 expects to be µ₁ − µ₂ + Δµ₀. It is positive where friction "
        "falls after the step."
    ),
    "fit_status": "Whether eq. 6 could be fitted, and if not, why.",
    "fit_window": (
        "The time t̄ at which the fit ends: where the deviation has fallen to 5 % of its first "
        "value, or at the end of the curve. The fit begins at the first step after the jump."
    ),
    "fit_quality": (
        "1 − (residual sum of squares)/(sum of squares of µ − µ₂) in the window. 1 is a perfect "
        "exponential."
    ),
    "deviation": "µ(t) − µ₂, to which eq. 6 is fitted.",
    "mu": "µ(t) = F_x/F_N after the velocity step, the mean over the lines. Sample 0 is µ₁ + Δµ₀.",
    "time": "t̄ = (t − t₀)/τ (eq. 7) of these samples.",
    "time_s": (
        't − t₀ of these samples, a coordinate in single precision, for `mu.plot(x="time_s")` at '
        "a point."
    ),
}
MODELS = {
    "best_model": (
        "Which of eq. 6, a stretched exponential and two exponentials best predicts the blocks of "
        "lines that were left out of its fit. A model must beat eq. 6 by two standard errors."
    ),
    "stretched_rate": "b of A exp(−(b t̄)^β); NaN where it does not beat eq. 6.",
    "stretched_exponent": "β of the same; 1 is eq. 6, less is a broader relaxation.",
    "fast_rate": "The larger b of two exponentials; NaN where they do not beat eq. 6.",
    "slow_rate": "The smaller b of two exponentials.",
    "fast_share": "The amplitude of the faster exponential over the sum of both.",
    "gain_stretched": (
        "1 − (squared error of prediction of the stretched exponential)/(that of eq. 6)."
    ),
    "gain_two_exponentials": "The same for two exponentials.",
}
EXPONENTS = {
    "alpha": (
        "α of b = x^α (eq. 13), by least squares of log b over log x through x = 1, over all "
        "distinct fitted and resolved points of one H with x > 1. The paper finds 1 − H."
    ),
    "alpha_free": "α of b = c x^α over the same points, with c fitted as well.",
    "alpha_prefactor": "c of the same; 1 if eq. 13 holds.",
    "alpha_scatter": "The rms of log₁₀(b/x^α): 0.1 means points off by a factor of 1.26.",
    "alpha_bias": "How far the discretisation errors of b may move `alpha`, all in one direction.",
    "alpha_free_bias": (
        "How far they may move `alpha_free`, fast and slow points in opposite directions."
    ),
    "alpha_unresolved": "How many fitted points with x > 1 are left out as unresolved.",
    "alpha_points": "How many points the fit of eq. 13 uses; fewer than 3 give NaN.",
}
GENERAL = {
    "rms_slope": (
        "∇z, the root of Σ q² A²/2 over the modes of the line: the paper's rms gradient. Friction "
        "over it depends on the dimensionless parameters alone."
    ),
    "speed_ratio": "x = v₁ τ q_max, the abscissa of figure 7, a coordinate.",
    "realizations": "How many lines the estimates average over; 0 where the computation failed.",
    "degrees_of_freedom": (
        "Groups of blocks in the jackknife, less one. `value ± t · error` is an interval of "
        "confidence with Student's t for this number."
    ),
    "steps_per_spacing": "m: time steps, samples and elements per Δx at this point.",
    "accuracy_reached": (
        "With `numerics.accuracy`, the largest, over what was asked for, of relative standard "
        "error plus bound of the relative discretisation error; infinite where that is not known, "
        "NaN where nothing has a relative error."
    ),
    "accuracy_status": (
        "Whether that is within `numerics.accuracy`. `met_where_defined` means that an estimate "
        "without a relative error, such as a rate where nothing relaxes, was left out."
    ),
    "bias_bound": (
        "The largest of `mu_1_bias`, `jump_bias` and `relaxation_rate_bias`, as far as they were "
        "asked for. Nine in ten problems keep it. It is NaN for materials with branches, "
        "programmes and prescribed indentations, for which none is known. Of measured lines it is "
        "twice what halved steps change."
    ),
    "samples_per_contact": (
        "How many samples of the line lie in one patch of contact at v₁, in the march or, where "
        "nothing is marched, in what friction rests on: the median over the load, averaged over "
        "the lines."
    ),
    "resolution_status": (
        "Whether contacts are wide enough, in samples, for their numbers to be physics."
    ),
    "tau": (
        "τ = `relaxation_time` + Σ g_b t_b/G at each temperature, by which times are made "
        "dimensionless. A coordinate."
    ),
    "shear_modulus": "The relaxed shear modulus G. A coordinate.",
    "length": (
        "L of F̄ = F_N/(4GLh), `surface.length` or that of a measured line before it is mirrored. "
        "A coordinate."
    ),
    "q_max": "The largest wave number of the line, π/Δx or 2π/`surface.cutoff`. A coordinate.",
    "power_spectrum": (
        "C₁D(q) of measured lines or lines like them, with ∫ C₁D dq = h² and ∫ C₁D q² dq = ∇z²."
    ),
}
