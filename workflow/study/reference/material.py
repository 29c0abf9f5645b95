"""Texts of the table [material]."""

from .text import Text

MATERIAL = {
    "shear_modulus": Text(
        "The relaxed (static, long-time) shear modulus G of the elastomer.",
        "Doubled, the same force presses the line in half as far as long as the contact stays the "
        "same. For a Kelvin element it is exactly as if all normal forces were halved, because "
        "they enter as F̄ = F_N/(4GLh) alone.",
        "Pa",
    ),
    "relaxation_time": Text(
        "The relaxation time τ = η/G of the dashpot of viscosity η beside the springs. Without "
        "branches the material is the Kelvin element of the paper, and τ is its only time. "
        "0 means that there is no dashpot, and needs branches.",
        "Doubled, a Kelvin element at the velocity v rubs exactly as it did at 2v, and relaxation "
        "takes twice the time.",
        "s",
        default="0 where there are branches, else required",
    ),
    "branches": Text(
        "A Prony series: Maxwell elements of modulus g_b and relaxation time t_b beside the "
        "spring G, so that the relaxation modulus is G(t) = G + Σ g_b exp(−t/t_b). The order does "
        "not matter.",
        "With all g_b doubled, what the branches dissipate in a given motion doubles, and so do "
        "instantaneous forces. With all t_b doubled (and no dashpot), friction at v is what it "
        "was at 2v.",
        "Pa, s",
        values="a list of `[g_b, t_b]`, 200 at most, with g_b from 1e-9 to 1e9 times "
        "`shear_modulus` and t_b from 1e-30 to 1e30 s",
        default="none",
    ),
    "branches_file": Text(
        "A text file beside `study.toml` with the two columns g_b and t_b, in place of `branches`. "
        "The command `prony` writes such a file from measured moduli.",
        "Another file is another material.",
        "Pa, s",
        values="the name of a file",
        default="none",
    ),
    "wlf": Text(
        "The constants of the shift of Williams, Landel and Ferry, log₁₀ a_T = −c1 (T − "
        "reference)/(c2 + T − reference). All relaxation times are multiplied by a_T. It goes "
        "together with `temperature`.",
        "With c1 doubled, the shift doubles in decades at every temperature.",
        values="`{c1 = …, c2 = …, reference = …}`",
        default="none: times are as they are given",
    ),
    "temperature": Text(
        "The temperature of the elastomer, with `wlf`. A list makes it a dimension of the result.",
        "A higher temperature shortens all times: friction at v is what it was at a_T v. "
        "Doubling degrees Celsius has no meaning of its own.",
        "°C",
        values="a number above `reference` − c2, or a list or range of them",
        default="none",
    ),
}
WLF = {
    "c1": Text(
        "The first constant of the shift, in decades.",
        "Doubled, times shift by twice as many decades.",
    ),
    "c2": Text(
        "The second constant of the shift.",
        "Doubled, times depend half as strongly on the temperature near the reference.",
        "K",
    ),
    "reference": Text(
        "The temperature at which the relaxation times are those that are given.",
        "Raised by ten degrees, all curves are those that were found ten degrees lower. "
        "Doubling degrees Celsius has no meaning of its own.",
        "°C",
    ),
}
