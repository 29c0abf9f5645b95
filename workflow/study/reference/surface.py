"""Texts of the tables [surface] and [grid]."""

from .text import Text

WITH_FILE = "With `surface.file` alone. "
SURFACE = {
    "length": Text(
        "The length L of the periodic line.",
        "Doubled at the same spacing, the line has twice as many elements and takes twice the "
        "time, its longest wave doubles, F̄ = F_N/(4GLh) halves, and at the same roughness its "
        "rms slope falls by about 2^H.",
        "m",
        default="required for random lines, left out with `file`",
    ),
    "normalisation": Text(
        'What the roughness h of the grid is: with `"modal"` every line has exactly this rms '
        'height; with `"integral"` it is the integral of the spectral density as the paper '
        "defines it, which differs from that by a factor of 1.04 (H = 0) to 1.55 (H = 1) at 5000 "
        "elements.",
        "It scales heights, and with them slopes, friction and F̄.",
    ),
    "snap_spacing": Text(
        "Whether each spacing is moved to the nearest one that divides the length into a number "
        "of elements 2^a 3^b 5^c, which are quick for the Fourier transform. Otherwise a spacing "
        "must divide the length.",
        "The result holds the spacings that were used.",
    ),
    "rolloff": Text(
        "The wavelength above which the power spectrum is flat.",
        "Doubled, more of the roughness lies in long waves: at the same h the rms slope falls by "
        "about 2^H.",
        "m",
        default="none: the power law goes on to the length of the line, as in the paper",
    ),
    "cutoff": Text(
        "The shortest wavelength of the line, at least two spacings. It makes the roughness "
        "independent of the spacing of elements.",
        "Doubled, q_max = 2π/cutoff and x = v₁ τ q_max halve, and the rms slope falls by about "
        "2^(1−H).",
        "m",
        default="twice the spacing, as in the paper",
    ),
    "file": Text(
        "A file of measured lines beside `study.toml`: text (`.txt`, `.csv`), `.npy`, `.nc`, or "
        "what the optional reader of instruments' files knows.",
        "Another file is another surface. H, spacing and roughness are then those of the file.",
        values="the name of a file",
        default="none: lines are random and self-affine",
    ),
    "columns": Text(
        WITH_FILE + "The columns of positions and of the heights of one line or more, counted "
        "from 0, or in a netCDF file the names of the two variables.",
        "Other columns are other lines.",
        values='whole numbers as `[0, 1]`, or two names as `["x", "height"]`',
        default="the first two columns, or the only variable of heights",
    ),
    "units": Text(
        WITH_FILE + "The units of positions and heights.",
        "They scale the line; they are never guessed.",
        values='two units of length as `["mm", "um"]`',
        default="those that the file names; required where it names none",
    ),
    "detrend": Text(
        WITH_FILE + "What is subtracted from each line: nothing, its mean, a straight line (tilt) "
        "or a parabola (tilt and bow).",
        "A higher degree removes longer waves, and with them roughness.",
    ),
    "periodic": Text(
        WITH_FILE + "How a measured line becomes periodic: `mirror` appends it reversed, `taper` "
        "brings both ends to the mean height over a tenth of the length, `none` takes it as one "
        "period.",
        "`mirror` doubles the period and loses the direction of a texture; `none` leaves a step "
        "where the ends do not meet.",
    ),
    "lines": Text(
        WITH_FILE + "Whether the measured lines slide, random lines of the same mean power "
        "spectrum, or self-affine lines of the same rms height and slope.",
        "What the three differ in is what a spectrum, or height and slope, leave out.",
    ),
    "hurst": Text(
        'With `lines = "self-affine"` alone: the Hurst exponent H of those lines.',
        "A larger exponent puts more of the roughness into long waves. Doubling is possible up "
        "to H = 1.",
    ),
}
GRID = {
    "hurst": Text(
        "The Hurst exponent H of the line, whose power spectral density falls as q^(−2H−1).",
        "Doubled (up to 1), the line is smoother: at the same roughness its rms slope is smaller, "
        "and for x > 1 the relaxation rate grows more slowly with the velocity, b ≈ x^(1−H).",
        default="required for random lines, left out with `surface.file`",
    ),
    "normal_force": Text(
        "The normal force F_N on the line of length L.",
        "Doubled, F̄ = F_N/(4GLh) doubles and more of the line touches. In full contact µ halves; "
        "in partial contact it changes less.",
        "N",
        default="required, left out where the indentation is prescribed",
    ),
    "spacing": Text(
        "The spacing Δx of the elements. It is a physical parameter: without a cut-off the "
        "shortest wave of the line is 2Δx, and q_max = π/Δx. The accuracy of a computation is "
        "set by `numerics.steps_per_spacing` instead.",
        "Doubled, there are half as many elements, x = v₁ τ q_max halves, and the rms slope falls "
        "by about 2^(1−H).",
        "m",
        default="required for random lines, left out with `surface.file`",
    ),
    "roughness": Text(
        "The rms roughness h of the line.",
        "Doubled, slopes double and F̄ = F_N/(4GLh) halves: µ is twice what it was at half the "
        "normal force.",
        "m",
        default="required for random lines, left out with `surface.file`",
    ),
    "velocity": Text(
        "The sliding velocity v₁ before the velocity step, or the velocity to which `ratio` in a "
        "programme refers.",
        "Doubled, x = v₁ τ q_max doubles. In region I (x < 1) steady friction doubles, on the "
        "plateau it hardly changes.",
        "m/s",
        default="required, left out where no segment of a programme depends on it",
    ),
    "velocity_step": Text(
        "The relative velocity step Δv/v₁, so that v₂ = v₁ (1 + Δv/v₁).",
        "Doubled, small steps make twice the jump Δµ₀ of friction; the relaxation rate b hardly "
        "changes.",
        values="a number above −1, zero or at least 1e-9 in size, or a list or range of such "
        "numbers",
        default="required, left out with a programme and where steady sliding alone is asked for",
    ),
    "prescribed_indentation": Text(
        "The indentation d of the line over its mean height, positive where the mean line lies "
        'below the undeformed surface; with `scene.control = "indentation"` alone.',
        "Doubled in full contact, the normal force doubles and the coefficient of friction halves.",
        "m",
        default="left out but with control by indentation",
    ),
}
