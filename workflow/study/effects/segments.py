"""Read [[scene.programme]]: one table per segment, with one kind of segment in each."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ...ground import UserError
from ...text_tables import ColumnSpec, describe_columns, read_text_table, select_columns
from ..settings import (
    NOT_ZERO,
    NUMBER,
    Key,
    as_table,
    as_text,
    checked_values,
    integer,
    number,
    one_or_several,
    pair,
    positive,
    read_table,
    two_numbers,
    within,
)
from .programme import (
    FromFile,
    HoldSegment,
    Oscillate,
    Programme,
    RampSegment,
    Segment,
    SlideSegment,
    Velocity,
)

MOST_SEGMENTS = 1000
PULLED = "pull"  # the kind of segment of a programme that is a drive's
MOST_SAMPLES = 100_000  # of a file
TIME = ColumnSpec("a time", "time", r"time|zeit|^t$", "s", "a header with units that are known")
VELOCITY = TIME._replace(
    meaning="a velocity", family="velocity", names=r"vel|speed|^v([_ ]|$)", default="m/s"
)
INDENTED = TIME._replace(
    meaning="an indentation", family="length", names=r"ind|depth|^d([_ ]|$)", default="m"
)


def _not_zero(key: str, value: object) -> float:
    checked = number(key, value)
    if checked == 0.0:
        raise UserError(f"{key} = {value!r}: must not be zero; use hold")
    return checked


def _pair(key: str, value: object) -> tuple[float, float]:
    return two_numbers(key, value, "[first, last]", number, number)


NOT_ZERO_OR_LEFT_OUT = partial(
    Key, _not_zero, default=None, values="a number other than 0", schema=NOT_ZERO
)
TWO_OR_LEFT_OUT = partial(
    Key, _pair, default=None, values="two numbers, `[first, last]`", schema=pair(NUMBER, NUMBER)
)
SLIDE = {
    "velocity": NOT_ZERO_OR_LEFT_OUT(
        "The velocity, backwards if negative. Give it or `ratio`.",
        "Doubled, x doubles, and the same distance takes half the time.",
        "m/s",
    ),
    "ratio": NOT_ZERO_OR_LEFT_OUT(
        "The velocity as a multiple of `grid.velocity`.",
        "Doubled, the motion is twice as fast.",
    ),
    "distance": Key(
        positive,
        "How far the line, or the drive, moves in this segment. Give it or `duration`.",
        "Doubled, the march of this segment takes twice as long.",
        "m",
        default=None,
    ),
    "duration": Key(
        positive,
        "How long this segment lasts.",
        "Doubled, the march of this segment takes twice as long.",
        "s",
        default=None,
    ),
}
RAMP = {
    "velocity": TWO_OR_LEFT_OUT(
        "The velocities at the beginning and at the end, linear in time between them. Give them "
        "or `ratio`.",
        "Doubled, the line moves twice as far in the same time, in twice as many steps.",
        "m/s",
    ),
    "ratio": TWO_OR_LEFT_OUT(
        "Both velocities as multiples of `grid.velocity`.",
        "Doubled, the line moves twice as far in the same time.",
    ),
    "duration": Key(
        positive,
        "How long the ramp takes.",
        "Doubled, the velocity changes half as quickly.",
        "s",
    ),
}
OSCILLATE = {
    "velocity": Key(
        number,
        "The mean velocity, on which the oscillation is superposed. Give it or `ratio`.",
        "Doubled, the mean motion is twice as fast.",
        "m/s",
        default=None,
        usual="0, where `ratio` is not given",
    ),
    "ratio": Key(
        number,
        "The mean velocity as a multiple of `grid.velocity`.",
        "Doubled, the mean motion is twice as fast.",
        default=None,
    ),
    "amplitude": Key(
        positive,
        "The amplitude of the displacement, a sine. Give it or `velocity_amplitude`.",
        "Doubled, a loop of small amplitude dissipates four times the work.",
        "m",
        default=None,
    ),
    "velocity_amplitude": Key(
        partial(one_or_several, positive),
        "The amplitude of the velocity, 2π `frequency` times that of the displacement. A list "
        "makes it a dimension of the result.",
        "Doubled, a loop of small amplitude dissipates four times the work.",
        "m/s",
        default=None,
    ),
    "frequency": Key(
        partial(one_or_several, positive),
        "The frequency of the oscillation. A list makes it a dimension of the result.",
        "Doubled, the response is that of the material at twice the frequency.",
        "Hz",
    ),
    "cycles": Key(
        partial(integer, least=1),
        "The number of cycles. The loop is evaluated in the last one, the mean over cycles in the "
        "later half of them.",
        "Doubled, the march takes twice as long and the start is forgotten better.",
    ),
}
HOLD = {
    "duration": Key(
        partial(checked_values, positive),
        "How long the line stays where it is. A list or range makes one programme for each value, "
        "and the dimension `hold` of the result; one hold of a programme may have it.",
        "Doubled, the contact ages twice as long, for a few steps more: steps grow with the age.",
        "s",
    ),
}
FILE = {  # the one segment that is no table
    "file": Key(
        as_text,
        "A text file with columns time (s, increasing) and velocity (m/s), or in the units and "
        "the order that its header names, linear between the rows. Times count from the first "
        'row. From Python, `{"time": …, "velocity": …}` takes two arrays in its place.',
        values="the name of a file with 2 to 100000 rows",
        usual="none",
    ),
}

PULL = {
    "velocity": Key(
        number,
        "The velocity of the drive, backwards if negative; 0 holds it. Give it, `ratio` or `file`.",
        "Doubled, the drive goes twice as fast, and the line after it.",
        "m/s",
        default=None,
    ),
    "ratio": SLIDE["ratio"],
    "file": replace(FILE["file"], default=None),
    "distance": SLIDE["distance"],
    "duration": replace(
        SLIDE["duration"],
        check=partial(one_or_several, positive),
        means="How long the drive moves like this. Where it is held, at velocity 0, a list or "
        "range makes one programme for each value, and the dimension `hold` of the result.",
        doubled="Doubled, the march of this segment takes twice as long, and what is held ages "
        "longer.",
    ),
}
HEAVIEST = 1e12  # of a mass and a damper: beyond them nothing moves

DRIVE = {
    "stiffness": Key(
        partial(one_or_several, positive),
        "The stiffness k of the spring between the drive and the line. A list makes it a "
        "dimension of the result.",
        "Doubled, the line follows the drive more closely; below a critical stiffness it sticks "
        "and slips where friction falls with the velocity.",
        "N/m",
    ),
    "mass": Key(
        partial(within, least=0.0, most=HEAVIEST),
        "The mass of the slider.",
        "Doubled, the slider comes free and stops more slowly.",
        "kg",
        default=0.0,
    ),
    "damping": Key(
        partial(within, least=0.0, most=HEAVIEST),
        "The constant c of a damper beside the spring, whose force is c (dY/dt − dX/dt).",
        "Doubled, the drive holds the slider back twice as strongly where it runs ahead.",
        "N s/m",
        default=0.0,
    ),
}


SEGMENTS = {  # the keys of each kind
    "slide": SLIDE,
    "hold": HOLD,
    "ramp": RAMP,
    "oscillate": OSCILLATE,
    PULLED: PULL,
    "file": FILE,
}


def _one_of(where: str, given: dict[str, Any], *names: str) -> str:
    """Return the one of some keys that was given. Raises UserError for none and for two."""
    found = [name for name in names if given[name] is not None]
    if len(found) != 1:
        raise UserError(f"{where}: give one of {' and '.join(names)}, not {len(found) or 'none'}")
    return found[0]


def _velocity(given: dict[str, Any], kind: str) -> Velocity:
    return Velocity(given[kind], kind == "ratio")


def _slide(where: str, table: Any, _: Path) -> SlideSegment:
    given = read_table(where, table, SLIDE)
    kind = _one_of(where, given, "velocity", "ratio")
    _one_of(where, given, "distance", "duration")
    return SlideSegment(_velocity(given, kind), given["distance"], given["duration"])


def _hold(where: str, table: Any, _: Path) -> HoldSegment:
    durations = read_table(where, table, HOLD)["duration"]
    return HoldSegment(durations, isinstance(table["duration"], list | dict))


def _pull(where: str, table: Any, folder: Path) -> Segment:
    """Return how a drive moves: as a line that slides, that is held or follows a file."""
    if isinstance(table, dict) and set(table) == {"time", "velocity"}:
        return _arrays(where, table)
    given = read_table(where, table, PULL)
    kind = _one_of(where, given, "velocity", "ratio", "file")
    distance, duration = given["distance"], given["duration"]
    if kind == "file":
        if distance or duration:
            raise UserError(f"{where}.file: says how long it takes; give no distance or duration")
        return _file(f"{where}.file", given["file"], folder)
    size = _one_of(where, given, "distance", "duration")
    several = isinstance(duration, tuple)
    if given[kind] == 0.0:
        if size == "distance":
            raise UserError(f"{where}.distance: at velocity 0 the drive goes no way; give duration")
        return HoldSegment(duration if several else (duration,), several)
    if several:
        raise UserError(
            f"{where}.duration = {list(duration)!r:.60}: several values are for a drive that is "
            "held, at velocity 0"
        )
    return SlideSegment(_velocity(given, kind), distance, duration)


def _ramp(where: str, table: Any, _: Path) -> RampSegment:
    given = read_table(where, table, RAMP)
    kind = _one_of(where, given, "velocity", "ratio")
    first, last = (Velocity(value, kind == "ratio") for value in given[kind])
    return RampSegment(first, last, given["duration"])


def _oscillate(where: str, table: Any, _: Path) -> Oscillate:
    given = read_table(where, table, OSCILLATE)
    if given["velocity"] is None and given["ratio"] is None:
        given["velocity"] = 0.0
    kind = _one_of(where, given, "velocity", "ratio")
    _one_of(where, given, "amplitude", "velocity_amplitude")
    lists = {key: own for key, own in given.items() if isinstance(own, tuple)}
    first = given | {key: values[0] for key, values in lists.items()}
    return Oscillate(
        _velocity(given, kind),
        first["amplitude"],
        first["frequency"],
        first["cycles"],
        first["velocity_amplitude"],
        tuple(lists.items()),
    ).with_derived_amplitude()


def _file(where: str, name: Any, folder: Path) -> FromFile:
    columns, said = read_sampled(where, folder / as_text(where, name), VELOCITY)
    return _driven(where, columns, said)


def _driven(where: str, columns: np.ndarray, said: str) -> FromFile:
    """Return the segment of times (s) and velocities (m/s), shape (2, samples)."""
    times, velocities = columns
    if not np.any(velocities):
        raise UserError(f"{where}: never moves; use hold")
    said = (
        f"{times.size} samples over {times[-1] - times[0]:g} s, {velocities.min():g} to "
        f"{velocities.max():g} m/s{said}"
    )
    return FromFile(tuple((times - times[0]).tolist()), tuple(velocities.tolist()), said)


def read_sampled(key: str, path: Path, wanted: ColumnSpec) -> tuple[np.ndarray, str]:
    """Return times and values of a file, shape (2, samples), in SI units, and how it was read.

    Times must be increasing. wanted : the second column. Raises UserError.
    """
    table = read_text_table(key, path, path.name)
    second = f"{wanted.meaning.split()[-1]} [{wanted.default}]"
    found = select_columns(table, (TIME, wanted), None, f"the header time [s], {second}")
    columns = np.array([one.values for one in found])
    _check_sampled(f"{key} = {path.name!r}", columns)
    return columns, f"; read {describe_columns(table, found)}"


def _check_sampled(key: str, columns: np.ndarray) -> None:
    """Raise UserError for times that do not increase, and for what is not finite."""
    if not 2 <= columns.shape[1] <= MOST_SAMPLES:
        raise UserError(f"{key}: holds {columns.shape[1]} rows; must be 2 to {MOST_SAMPLES}")
    missing, back = ~np.isfinite(columns).all(axis=0), np.diff(columns[0]) <= 0.0
    if missing.any():
        raise UserError(f"{key}: a value is missing in row {np.argmax(missing) + 1}")
    if back.any():
        row = np.argmax(back)
        raise UserError(
            f"{key}: time {columns[0, row + 1]:g} s does not come after {columns[0, row]:g} s; "
            "times must increase"
        )


def _arrays(where: str, table: dict[str, Any]) -> FromFile:
    """Return the segment of {"time": ..., "velocity": ...}, arrays in s and m/s."""
    lists = [table["time"], table["velocity"]]
    for name, values in zip(("time", "velocity"), lists, strict=True):
        if not isinstance(values, list):
            raise UserError(f"{where}.{name} = {values!r:.60}: must be a list of numbers")
    if len(lists[0]) != len(lists[1]):
        raise UserError(
            f"{where}: holds {len(lists[0])} times and {len(lists[1])} velocities; must be as many"
        )
    columns = np.array([[number(where, value) for value in values] for values in lists])
    _check_sampled(where, columns)
    return _driven(where, columns, "")


KINDS: dict[str, Callable[[str, Any, Path], Segment]] = {
    "slide": _slide,
    "hold": _hold,
    "ramp": _ramp,
    "oscillate": _oscillate,
    "file": _file,
    PULLED: _pull,
}


ONE_LIST: dict[type[HoldSegment | Oscillate], str] = {
    HoldSegment: "hold: only one hold of a programme may have a list of durations",
    Oscillate: "oscillate: only one oscillation of a programme may have lists",
}


def read_programme(key: str, value: object, folder: Path) -> Programme:
    """Return the segments of a list of tables; files are found from ``folder``.

    Raises UserError for what is no segment and for segments that do not go together.
    """
    if not isinstance(value, list) or not 1 <= len(value) <= MOST_SEGMENTS:
        raise UserError(f"{key} = {value!r:.60}: must be a list of 1 to {MOST_SEGMENTS} segments")
    programme = tuple(_segment(f"{key}[{i}]", entry, folder) for i, entry in enumerate(value))
    several = [(i, s) for i, s in enumerate(programme) if isinstance(s, HoldSegment | Oscillate)]
    for kind, words in ONE_LIST.items():
        lists = [i for i, segment in several if isinstance(segment, kind) and segment.several]
        if len(lists) > 1:
            raise UserError(f"{key}[{lists[1]}].{words}")
    for i, (before, after) in enumerate(pairwise(programme), 1):
        if isinstance(before, RampSegment) and isinstance(after, Oscillate):
            _check_mean(f"{key}[{i}].oscillate", before.last, after.velocity)
    return programme


def is_pulled(where: str, entries: list[dict[str, Any]]) -> bool:
    """Return whether a programme that was read is that of a drive.

    Raises UserError where a drive pulls in some of its segments alone.
    """
    pulled = [PULLED in entry for entry in entries]
    if any(pulled) and not all(pulled):
        raise UserError(
            f"{where}: pulls in some segments and moves the line itself in others; a drive is held "
            "by pull = {velocity = 0, duration = …}"
        )
    return any(pulled)


def _check_mean(where: str, ended: Velocity, mean: Velocity) -> None:
    if ended != mean and (ended.value or mean.value):
        unit = {True: "of grid.velocity", False: "m/s"}
        raise UserError(
            f"{where}: its mean velocity {mean.value:g} {unit[mean.relative]} must be that at "
            f"which the ramp before it ends, {ended.value:g} {unit[ended.relative]}"
        )


def _segment(where: str, entry: object, folder: Path) -> Segment:
    table = as_table(where, entry)
    kinds = list(table)
    if set(kinds) == {"time", "velocity"}:
        return _arrays(where, table)
    if len(kinds) != 1 or kinds[0] not in KINDS:
        found = ", ".join(kinds) or "nothing"
        raise UserError(f"{where} holds {found:.60}: must hold one out of {', '.join(KINDS)}")
    return KINDS[kinds[0]](f"{where}.{kinds[0]}", table[kinds[0]], folder)
