"""Texts of the table [scene] and of the segments of a programme."""

from .text import Text

ONE_OF_VELOCITY = "Give either `velocity` or `ratio`. "
ONE_OF_LENGTH = "Give either `distance` or `duration`. "
SCENE = {
    "quantities": Text(
        "What is computed. What is not named is neither computed nor in the result file; the "
        "list of names is in the table of quantities below.",
        "Each further name costs what it takes; steady states and jumps need no time marching.",
        values="a list of names of quantities",
        default='`["steady", "jump", "relaxation"]`; without a dashpot `["steady", "relaxation", '
        '"peak"]`; with a programme `["steady", "trace"]`; at a prescribed indentation '
        '`["trace"]`',
    ),
    "indentation_rate": Text(
        "Whether the rate ḋ of the indentation enters the force of an element. `false` is eq. 3 "
        "of the paper as it is printed, for one velocity step of Kelvin elements alone.",
        "Without it the velocity step has no physical relaxation; it is there for comparison.",
    ),
    "control": Text(
        "What presses line and elastomer together: a constant normal force, or with "
        '`"indentation"` a given indentation, from which the force follows.',
        "A programme is needed for control by indentation.",
    ),
    "indentation_file": Text(
        "A text file beside `study.toml` with the columns time (s) and indentation (m). The "
        "indentation is linear between the times and constant beyond them. It takes the place of "
        "`grid.prescribed_indentation`.",
        "Another file is another history of the indentation.",
        values="the name of a file",
        default="none",
    ),
    "start": Text(
        "How a programme begins: in steady sliding at its first velocity, at rest with the "
        "elastomer fully relaxed under the load, or just pressed on. The last needs a material "
        "without a dashpot.",
        "It changes the beginning of a trace; after a few relaxation times nothing is remembered "
        "of it.",
    ),
    "repeat": Text(
        "How often the whole programme is followed.",
        "Doubled, the march takes twice as long.",
    ),
    "programme": Text(
        "The motion of the line, as a list of segments `[[scene.programme]]` that follow one "
        "another. Without it there is one velocity step from v₁ to v₂.",
        "With a programme `grid.velocity_step` is left out.",
        values="a list of up to 1000 segments: `slide`, `hold`, `ramp`, `oscillate` or `file`",
        default="none",
    ),
}
SLIDE = {
    "velocity": Text(
        ONE_OF_VELOCITY + "The velocity of sliding; a negative one slides back.",
        "Doubled, x doubles, and the same distance takes half the time.",
        "m/s",
        values="a number other than 0",
        default="none",
    ),
    "ratio": Text(
        ONE_OF_VELOCITY + "The velocity of sliding as a multiple of `grid.velocity`.",
        "Doubled, the segment slides twice as fast.",
        values="a number other than 0",
        default="none",
    ),
    "distance": Text(
        ONE_OF_LENGTH + "The distance of sliding.",
        "Doubled, the march of this segment takes twice as long.",
        "m",
        default="none",
    ),
    "duration": Text(
        ONE_OF_LENGTH + "The duration of sliding.",
        "Doubled, the march of this segment takes twice as long.",
        "s",
        default="none",
    ),
}
HOLD = {
    "duration": Text(
        "How long the line stays where it is. A list or range makes one programme for each value, "
        "and the dimension `hold` of the result; one hold of a programme may have it.",
        "Doubled, the contact ages twice as long; steps of a hold grow with its age, so the cost "
        "grows by a few steps only.",
        "s",
    ),
}
RAMP = {
    "velocity": Text(
        ONE_OF_VELOCITY + "The velocities at the beginning and at the end; between them the "
        "velocity is linear in time.",
        "Doubled, the line moves twice as far in the same time, in twice as many steps.",
        "m/s",
        values="two numbers, `[first, last]`",
        default="none",
    ),
    "ratio": Text(
        ONE_OF_VELOCITY + "Both velocities as multiples of `grid.velocity`.",
        "Doubled, the line moves twice as far in the same time.",
        values="two numbers, `[first, last]`",
        default="none",
    ),
    "duration": Text(
        "How long the ramp takes.",
        "Doubled, the velocity changes half as quickly.",
        "s",
    ),
}
OSCILLATE = {
    "velocity": Text(
        ONE_OF_VELOCITY + "The mean velocity, on which the oscillation is superposed.",
        "Doubled, the mean motion is twice as fast.",
        "m/s",
        default="0, where `ratio` is not given",
    ),
    "ratio": Text(
        ONE_OF_VELOCITY + "The mean velocity as a multiple of `grid.velocity`.",
        "Doubled, the mean motion is twice as fast.",
        default="none",
    ),
    "amplitude": Text(
        "The amplitude of the displacement, a sine. Give either this or `velocity_amplitude`.",
        "Doubled, a loop of small amplitude dissipates four times the work.",
        "m",
        default="none",
    ),
    "velocity_amplitude": Text(
        "The amplitude of the velocity, 2π `frequency` times that of the displacement.",
        "Doubled, a loop of small amplitude dissipates four times the work.",
        "m/s",
        default="none",
    ),
    "frequency": Text(
        "The frequency of the oscillation.",
        "Doubled, the response is that of the material at twice the frequency.",
        "Hz",
    ),
    "cycles": Text(
        "The number of cycles. The loop is evaluated in the last one.",
        "Doubled, the march takes twice as long and starts are forgotten better.",
    ),
}
FILE = {
    "file": Text(
        "The name of a text file with the columns time (s, increasing) and velocity (m/s), linear "
        "between the rows. Times count from the first row.",
        "Another file is another motion.",
        "s, m/s",
        values="the name of a file with 2 to 100000 rows",
        default="none",
    ),
}
