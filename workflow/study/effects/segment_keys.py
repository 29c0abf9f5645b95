"""Keys of the segments of [[scene.programme]] and of the table [scene.drive]."""

from dataclasses import replace
from functools import partial

from ...ground import UserError
from ..settings import (
    NOT_ZERO,
    NUMBER,
    OPTIONAL,
    TEXT,
    Key,
    as_text,
    flag,
    integer,
    number,
    one_or_several,
    pair,
    positive,
    schema_of_keys,
    table_of,
    two_numbers,
    within,
)

MAX_SEGMENTS = 1000
MAX_MASS_OR_DAMPING = 1e12  # kg or N s/m; beyond it nothing moves


def _not_zero(key: str, value: object) -> float:
    checked = number(key, value)
    if checked == 0.0:
        raise UserError(f"{key} = {value!r}: must not be zero; use a segment hold")
    return checked


def _pair(key: str, value: object) -> tuple[float, float]:
    return two_numbers(key, value, "[first, last]", number, number)


OPTIONAL_NOT_ZERO = partial(
    Key, _not_zero, default=None, values="a number other than 0", schema=NOT_ZERO
)
OPTIONAL_PAIR = partial(
    Key, _pair, default=None, values="two numbers, `[first, last]`", schema=pair(NUMBER, NUMBER)
)
SLIDE = {
    "velocity": OPTIONAL_NOT_ZERO(
        "The velocity, backwards if negative, unless `ratio` is given.",
        "Doubled, x doubles.",
        "m/s",
    ),
    "ratio": OPTIONAL_NOT_ZERO(
        "The velocity as a multiple of `grid.velocity`.",
        "Doubled, so is the velocity.",
    ),
    "distance": OPTIONAL(
        positive,
        "The distance that the line, or the drive, moves, unless `duration` is given.",
        "Doubled, the march takes twice as long.",
        "m",
    ),
    "duration": OPTIONAL(
        positive,
        "The duration of the segment.",
        "Doubled, the march takes twice as long.",
        "s",
    ),
}
RAMP = {
    "velocity": OPTIONAL_PAIR(
        "The first and the last velocity, linear in time between them, unless `ratio` is given.",
        "Doubled, the march takes twice as long.",
        "m/s",
    ),
    "ratio": OPTIONAL_PAIR(
        "Both velocities as multiples of `grid.velocity`.",
        "Doubled, so are the velocities.",
    ),
    "duration": Key(
        positive,
        "The duration of the ramp.",
        "Doubled, the velocity changes half as quickly.",
        "s",
    ),
}
OSCILLATE = {
    "velocity": OPTIONAL(
        number,
        "The mean velocity, on which the oscillation is superposed, unless `ratio` is given.",
        "Doubled, so is the mean motion.",
        "m/s",
        usual="0 without `ratio`",
    ),
    "ratio": OPTIONAL(
        number,
        "The mean velocity as a multiple of `grid.velocity`.",
        "Doubled, so is the mean motion.",
    ),
    "amplitude": OPTIONAL(
        positive,
        "The amplitude of the displacement, unless `velocity_amplitude` is given.",
        "Doubled, a small loop dissipates four times the work.",
        "m",
    ),
    "velocity_amplitude": OPTIONAL(
        partial(one_or_several, positive),
        "The amplitude of the velocity, 2π `frequency` times that of the displacement.",
        "Doubled, a small loop dissipates four times the work.",
        "m/s",
    ),
    "frequency": Key(
        partial(one_or_several, positive),
        "The frequency of the oscillation.",
        "Doubled, the material responds at twice the frequency.",
        "Hz",
    ),
    "cycles": Key(
        partial(integer, least=1),
        "The number of cycles. The loop is that of the last cycle, the mean that of the second "
        "half.",
        "Doubled, the march takes twice as long.",
    ),
}
HOLD = {
    "duration": Key(
        partial(one_or_several, positive),
        "The duration of rest. A list makes one programme for each value and the dimension `hold` "
        "of the result; only one hold of a programme may have a list.",
        "Doubled, the contact ages twice as long.",
        "s",
    ),
}
FILE = {  # its value is text, not a table
    "file": Key(
        as_text,
        "A text file with columns time (s, increasing from 0) and velocity (m/s), or as its "
        'header says; the velocity is linear between the rows. Python also takes `{"time": …, '
        '"velocity": …}` with two arrays.',
        values="the name of a file with 2 to 100000 rows",
        usual="none",
    ),
}

PULL = {
    "velocity": OPTIONAL(
        number,
        "The velocity of the drive, backwards if negative, 0 to hold it, unless `ratio` or `file` "
        "is given.",
        "Doubled, the line moves twice as fast on average.",
        "m/s",
    ),
    "ratio": SLIDE["ratio"],
    "file": replace(
        FILE["file"], means="A text file of velocities, as for a segment `file`.", default=None
    ),
    "distance": SLIDE["distance"],
    "duration": replace(
        SLIDE["duration"],
        check=partial(one_or_several, positive),
        means="The duration of the segment. At velocity 0, a list makes one programme for each "
        "value and the dimension `hold` of the result.",
        doubled="Doubled, the march or the ageing takes twice as long.",
    ),
}

DRIVE = {
    "stiffness": Key(
        partial(one_or_several, positive),
        "The stiffness k of the spring between drive and line.",
        "Doubled, the line follows the drive more closely; stick-slip needs a low stiffness.",
        "N/m",
    ),
    "mass": Key(
        partial(within, least=0.0, most=MAX_MASS_OR_DAMPING),
        "The mass of the slider.",
        "Doubled, the slider accelerates half as fast.",
        "kg",
        default=0.0,
    ),
    "damping": Key(
        partial(within, least=0.0, most=MAX_MASS_OR_DAMPING),
        "The constant c of a damper parallel to the spring, with the force c (dY/dt − dX/dt).",
        "Doubled, so is that force.",
        "N s/m",
        default=0.0,
    ),
    "per_normal_force": Key(
        flag,
        "Whether `stiffness`, `mass` and `damping` are those of the machine over its normal force, "
        "in 1/m, kg/N and s/m. They are then multiplied by the normal force of the model.",
        default=False,
    ),
}

SEGMENTS = {  # kind -> keys
    "slide": SLIDE,
    "hold": HOLD,
    "ramp": RAMP,
    "oscillate": OSCILLATE,
    "pull": PULL,
    "file": FILE,
}
SEGMENT_SCHEMA = {  # a table with one key, its kind
    **table_of({kind: schema_of_keys(SEGMENTS[kind]) for kind in SEGMENTS} | {"file": TEXT}),
    "minProperties": 1,
    "maxProperties": 1,
}
PROGRAMME_SCHEMA = {
    "anyOf": [
        {"type": "array", "minItems": 1, "maxItems": MAX_SEGMENTS, "items": SEGMENT_SCHEMA},
        SEGMENT_SCHEMA,
    ]
}
