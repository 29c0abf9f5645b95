"""Read the programme [[scene.programme]], a list of tables with one segment each."""

from itertools import pairwise
from pathlib import Path
from typing import Any

from ...ground import UserError
from ..settings import as_table, as_text, read_table
from .histories import velocity_arrays, velocity_file
from .programme import (
    HoldSegment,
    Oscillate,
    Programme,
    RampSegment,
    Segment,
    SlideSegment,
    Velocity,
)
from .segment_keys import MAX_SEGMENTS, SEGMENTS

KEY = "scene.programme"
ARRAYS = {"time", "velocity"}  # keys of a sampled velocity from Python
SINGLE_LIST: dict[type[HoldSegment | Oscillate], str] = {
    HoldSegment: "hold: only one hold of a programme may have a list of durations",
    Oscillate: "oscillate: only one oscillation of a programme may have lists",
}
Checked = dict[str, Any]  # key -> checked value of a segment, None if it is not given


def read_programme(value: object, folder: Path) -> Programme:
    """Return the segments described by a list of tables. Raises UserError for invalid tables.

    folder : folder of the files that the segments name.
    """
    if not isinstance(value, list) or not 1 <= len(value) <= MAX_SEGMENTS:
        raise UserError(f"{KEY} = {value!r:.60}: must be a list of 1 to {MAX_SEGMENTS} segments")
    programme = tuple(_segment(f"{KEY}[{i}]", entry, folder) for i, entry in enumerate(value))
    for kind, message in SINGLE_LIST.items():
        lists = [i for i, part in enumerate(programme) if isinstance(part, kind) and part.several]
        if len(lists) > 1:
            raise UserError(f"{KEY}[{lists[1]}].{message}")
    for i, (before, after) in enumerate(pairwise(programme), 1):
        if isinstance(before, RampSegment) and isinstance(after, Oscillate):
            _check_continuous(f"{KEY}[{i}].oscillate", before.last, after.velocity)
    return programme


def is_pulled(entries: list[dict[str, Any]]) -> bool:
    """Return whether the segments of a programme move a drive, not the line.

    Raises UserError if only some of them do.
    """
    pulled = ["pull" in entry for entry in entries]
    if any(pulled) and not all(pulled):
        raise UserError(
            f"{KEY}: some segments pull and others move the line; use pull for all segments, and "
            "pull = {velocity = 0, duration = …} to hold the drive"
        )
    return any(pulled)


def _segment(where: str, entry: object, folder: Path) -> Segment:
    """Return the segment described by one entry of the list."""
    table = as_table(where, entry)
    if table.keys() == ARRAYS:
        return velocity_arrays(where, table)
    if len(table) != 1 or not table.keys() <= SEGMENTS.keys():
        kinds = ", ".join(table) or "nothing"
        raise UserError(f"{where} holds {kinds:.60}: must hold one out of {', '.join(SEGMENTS)}")
    ((kind, content),) = table.items()
    where = f"{where}.{kind}"
    if kind == "file":
        return velocity_file(where, folder / as_text(where, content))
    if kind == "pull" and isinstance(content, dict) and content.keys() == ARRAYS:
        return velocity_arrays(where, content)
    checked = read_table(where, content, SEGMENTS[kind])
    match kind:
        case "slide":
            velocity = _velocity(where, checked)
            _only_key(where, checked, "distance", "duration")
            return SlideSegment(velocity, checked["distance"], checked["duration"])
        case "hold":
            return _hold(checked["duration"])
        case "ramp":
            key = _only_key(where, checked, "velocity", "ratio")
            first, last = (Velocity(value, key == "ratio") for value in checked[key])
            return RampSegment(first, last, checked["duration"])
        case "oscillate":
            return _oscillate(where, checked)
    return _pull(where, checked, folder)


def _hold(duration: float | tuple[float, ...]) -> HoldSegment:
    if isinstance(duration, tuple):
        return HoldSegment(duration, several=True)
    return HoldSegment((duration,))


def _oscillate(where: str, checked: Checked) -> Oscillate:
    if checked["velocity"] is None and checked["ratio"] is None:
        checked["velocity"] = 0.0
    velocity = _velocity(where, checked)
    _only_key(where, checked, "amplitude", "velocity_amplitude")
    lists = {key: values for key, values in checked.items() if isinstance(values, tuple)}
    first = checked | {key: values[0] for key, values in lists.items()}
    return Oscillate(
        velocity,
        first["amplitude"],
        first["frequency"],
        first["cycles"],
        first["velocity_amplitude"],
        tuple(lists.items()),
    ).with_derived_amplitude()


def _pull(where: str, checked: Checked, folder: Path) -> Segment:
    """Return the motion of a drive: a slide, a hold or a sampled velocity."""
    key = _only_key(where, checked, "velocity", "ratio", "file")
    distance, duration = checked["distance"], checked["duration"]
    if key == "file":
        if distance or duration:
            raise UserError(f"{where}.file: determines the duration; omit distance and duration")
        return velocity_file(f"{where}.file", folder / checked["file"])
    length = _only_key(where, checked, "distance", "duration")
    if checked[key] == 0.0:
        if length == "distance":
            raise UserError(
                f"{where}.distance = {distance!r}: must be omitted at velocity 0; give duration"
            )
        return _hold(duration)
    if isinstance(duration, tuple):
        raise UserError(
            f"{where}.duration = {list(duration)!r:.60}: must be one number, except at velocity 0"
        )
    return SlideSegment(Velocity(checked[key], key == "ratio"), distance, duration)


def _only_key(where: str, checked: Checked, *names: str) -> str:
    """Return the single given key out of ``names``. Raises UserError for none or several."""
    present = [name for name in names if checked[name] is not None]
    if len(present) != 1:
        raise UserError(f"{where}: give one of {' and '.join(names)}, not {len(present) or 'none'}")
    return present[0]


def _velocity(where: str, checked: Checked) -> Velocity:
    key = _only_key(where, checked, "velocity", "ratio")
    return Velocity(checked[key], key == "ratio")


def _check_continuous(where: str, end: Velocity, mean: Velocity) -> None:
    """Raise UserError if an oscillation does not continue at the final velocity of a ramp."""
    if end != mean and (end.value or mean.value):
        unit = {True: "of grid.velocity", False: "m/s"}
        raise UserError(
            f"{where}: its mean velocity {mean.value:g} {unit[mean.relative]} must be that at "
            f"which the ramp before it ends, {end.value:g} {unit[end.relative]}"
        )
