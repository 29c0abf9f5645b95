"""Texts of the table [numerics]."""

from .text import Text

NUMERICS = {
    "scheme": Text(
        "The time step of an element. `exponential` lets a free element decay by exp(−Δt/τ) and "
        "is of second order; `implicit-euler` lets it decay by 1/(1 + Δt/τ) and is of first "
        "order. With one step per spacing the latter gives the left branch of figure 7.",
        "Both converge to the same result as `steps_per_spacing` grows.",
    ),
    "steps_per_spacing": Text(
        "The number m of time steps in which the line moves by one spacing Δx, and of samples of "
        'the line, each with an element, per Δx. With `"auto"` each point takes the least m that '
        "keeps the discretisation error of what is asked for below 2 %, where that can be, and the "
        "steady friction and the jump of contacts that are narrower than 24 samples are read from "
        "finer samples there. No law of the error is known for measured lines, for which it takes "
        "4, and for materials with branches and programmes, for which it takes 8. A number is "
        "taken as it is at every point: nothing is refined, and `resolution_status` marks the "
        "contacts that it does not resolve.",
        "Doubled, the discretisation error of µ₁ falls to about a third, those of Δµ₀ and b to "
        "about half; steady states take twice the time and relaxation up to four times.",
        values='a whole number, at least 1, or `"auto"`',
        default='`"auto"`',
    ),
    "samples": Text(
        "The number of points that are kept of each relaxation curve or trace.",
        "Doubled, curves have twice as many points and the file is larger; the fit of eq. 6 rests "
        "on more points and changes slightly.",
        default="64; 200 in `scene.run`",
    ),
    "horizon": Text(
        "How long the relaxation is followed, in expected relaxation times.",
        "Doubled, the march after the velocity step takes twice as many steps. Beyond 4 the "
        "relaxation rate changes by about half a percent.",
        default="4; 6 where `accuracy` is below 1 %",
    ),
    "accuracy": Text(
        "The wanted relative error of µ₁, Δµ₀ and b, as far as they are asked for: standard error "
        "plus bound of the discretisation error. The program then chooses m and the number of "
        "lines for each point, and `study.realizations` is not used.",
        "Doubled, a quarter of the lines is needed, and often fewer steps.",
        default="none: `study.realizations` says how many lines there are",
    ),
    "max_realizations": Text(
        "With `accuracy`: the number of lines at which a point ends even if it has not reached the "
        "accuracy. The result says where that happened.",
        "Doubled, points that are hard to determine may take twice the time and come out with an "
        "error smaller by √2.",
    ),
    "negligible": Text(
        "A share of the jump Δµ₀. Where surely less than this share relaxes, no line is added to "
        "determine the rate b, and `fit_status` says `negligible`.",
        "Doubled, the rate is left undetermined at more points with x < 1.",
        default="0; 0.01 where `accuracy` is given",
    ),
    "record": Text(
        "In what the kept points of a trace are evenly spaced: time, distance slid, or the "
        "logarithm of time.",
        "It says where curves have their points, and changes no point.",
    ),
    "trace": Text(
        "Keep every step whose number is a multiple of this one, instead of `samples` points. It "
        "excludes `record`.",
        "Doubled, a trace has half as many points.",
        default="none",
    ),
}
