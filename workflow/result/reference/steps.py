"""Meanings of what a velocity step gives: steady states, the jump, relaxation and its fits."""

from .meaning import Meaning

STEADY = {
    "mu_1": Meaning(
        "µ₁ = F_x/F_N (eq. 5) in steady sliding at v₁, the mean over the lines.",
        "Positive where friction opposes the sliding; a negative mean is noise or discretisation.",
    ),
    "mu_2": Meaning("µ₂, the same at v₂ = v₁ (1 + Δv/v₁).", "As of `mu_1`."),
    "indentation": Meaning(
        "The indentation d of eq. 4, by which the mean height of the line lies below the "
        "undeformed surface of the elastomer: in contact the displacement is u = z − d.",
        "Negative at light loads, where only the lowest parts of the line reach the elastomer.",
    ),
    "contact_fraction": Meaning(
        "The share of the line whose elements carry a force, from 0 to 1, in steady sliding at v₁."
    ),
}
JUMP = {
    "jump": Meaning(
        "Δµ₀ = µ(t₀⁺) − µ₁ of eqs. 8 to 12: the displacements are unchanged, while the velocity "
        "and the rate of the indentation jump.",
        "Positive where the velocity grows.",
    ),
}
RELAXATION = {
    "relaxation_rate": Meaning(
        "b of µ − µ₂ = µ* exp(−b t̄), t̄ = (t − t₀)/τ (eqs. 6 and 7). Only µ* and b are fitted; µ₂ "
        "is known from steady sliding. The relaxation time is τ/b. It is a number where "
        "`fit_status` is `fitted` or `negligible`, else NaN.",
    ),
    "relaxation_rate_free": Meaning("b of eq. 6 where µ₂ is fitted as well."),
    "amplitude": Meaning(
        "µ* of eq. 6, which eq. 8 expects to be µ₁ − µ₂ + Δµ₀.",
        "Positive where friction falls after the step.",
    ),
    "fit_status": Meaning("Whether eq. 6 could be fitted, and if not, why."),
    "fit_window": Meaning(
        "The time t̄ at which the fit ends: where the deviation has fallen to 5 % of its first "
        "value, or at the end of the curve. Times of the window count from the velocity step."
    ),
    "fit_quality": Meaning(
        "1 − (residual sum of squares)/(sum of squares of µ − µ₂) in the window. 1 is a perfect "
        "exponential; below 0.8 the status is `not_exponential`."
    ),
    "deviation": Meaning("µ(t) − µ₂, the curve to which eq. 6 is fitted.", "As of `amplitude`."),
    "mu": Meaning(
        "µ(t) = F_x/F_N after the velocity step, the mean over the lines. Sample 0 is µ₁ + Δµ₀."
    ),
    "time": Meaning("t̄ = (t − t₀)/τ (eq. 7) of the samples of `mu` and `deviation`."),
    "time_s": Meaning(
        't − t₀ of the same samples in seconds, a coordinate: `mu.plot(x="time_s")` at a point. '
        "It is kept in single precision."
    ),
}
MODELS = {
    "best_model": Meaning(
        "Which of eq. 6, a stretched exponential and two exponentials best predicts the blocks of "
        "lines that were left out of its fit. A model must beat eq. 6 by two standard errors."
    ),
    "stretched_rate": Meaning("b of A exp(−(b t̄)^β); NaN where it does not beat eq. 6."),
    "stretched_exponent": Meaning("β of the same; 1 is eq. 6, less is a broader relaxation."),
    "fast_rate": Meaning("The larger b of two exponentials; NaN where they do not beat eq. 6."),
    "slow_rate": Meaning("The smaller b of two exponentials."),
    "fast_share": Meaning("The amplitude of the faster exponential over the sum of both."),
    "gain_stretched": Meaning(
        "1 − (squared error of prediction of the stretched exponential)/(that of eq. 6).",
        "Negative where it predicts worse than eq. 6.",
    ),
    "gain_two_exponentials": Meaning(
        "The same for two exponentials.", "Negative where they predict worse than eq. 6."
    ),
}
EXPONENTS = {
    "alpha": Meaning(
        "α of b = (v₁ τ q_max)^α (eq. 13), by least squares of log b over log x through x = 1, "
        "over all distinct points of one H with x > 1 that are fitted and resolved. The paper "
        "finds 1 − H."
    ),
    "alpha_free": Meaning("α of b = c x^α with the prefactor c fitted as well."),
    "alpha_prefactor": Meaning("c of b = c x^α; 1 if eq. 13 holds."),
    "alpha_scatter": Meaning("The rms of log₁₀(b/x^α): 0.1 means points off by a factor of 1.26."),
    "alpha_bias": Meaning("How far the discretisation errors of b may move `alpha`."),
    "alpha_free_bias": Meaning("How far the discretisation errors of b may move `alpha_free`."),
    "alpha_unresolved": Meaning("How many fitted points with x > 1 are left out as unresolved."),
    "alpha_points": Meaning("How many points the fit of eq. 13 uses; fewer than 3 give NaN."),
}
GENERAL = {
    "rms_slope": Meaning(
        "∇z, the square root of Σ q² A²/2 over the modes of the line: the paper's rms gradient. "
        "Friction divided by it depends on the dimensionless parameters alone."
    ),
    "speed_ratio": Meaning(
        "x = v₁ τ q_max, the abscissa of figure 7; q_max = π/Δx, or 2π/`surface.cutoff`. A "
        "coordinate."
    ),
    "realizations": Meaning("How many lines the estimates of this point average over."),
    "degrees_of_freedom": Meaning(
        "Groups of blocks in the jackknife, less one. `value ± t · error` is an interval of "
        "confidence with Student's t for this number."
    ),
    "steps_per_spacing": Meaning("m: time steps, samples and elements per Δx at this point."),
    "accuracy_reached": Meaning(
        "The largest, over what was asked for, of relative standard error plus bound of the "
        "relative discretisation error; with `numerics.accuracy`."
    ),
    "accuracy_status": Meaning(
        "Whether that is within `numerics.accuracy`. `met_where_defined` means that an estimate "
        "without a relative error, such as a rate where nothing relaxes, was left out."
    ),
    "bias_bound": Meaning(
        "The largest of `mu_1_bias`, `jump_bias` and `relaxation_rate_bias`, as far as they were "
        "asked for."
    ),
    "samples_per_contact": Meaning(
        "How many samples of the line lie in one patch of contact in steady sliding at v₁: the "
        "median over the load, averaged over the lines."
    ),
    "resolution_status": Meaning(
        "Whether contacts are wide enough, in samples, for their numbers to be physics."
    ),
    "tau": Meaning(
        "τ = `relaxation_time` + Σ g_b t_b/G, by which times are made dimensionless, at each "
        "temperature. A coordinate."
    ),
    "shear_modulus": Meaning("The relaxed shear modulus G of the material. A coordinate."),
    "length": Meaning(
        "L of F̄ = F_N/(4GLh): `surface.length`, or that of a measured line before it is mirrored. "
        "A coordinate."
    ),
    "q_max": Meaning(
        "The largest wave number of the line, π/Δx or 2π/`surface.cutoff`. A coordinate."
    ),
    "power_spectrum": Meaning(
        "C₁D(q) of measured lines or lines like them, with ∫ C₁D dq = h² and ∫ C₁D q² dq = ∇z²."
    ),
}
