"""Names of the memories of a law by their origin: age of contacts, contact or temperature.

The temperature of the contact is fitted by the exponential memory of each state alone, with the
length and time of that state and a free table over the speed. A memory that explains the changes of
the temperature about as well as the best one is named "temperature".
"""

import re
from collections import Counter
from collections.abc import Sequence

import numpy as np

from ..given_motion import LawError
from .transients import Transient

AGE, CONTACT, TEMPERATURE, UNKNOWN = "age", "contact", "temperature", "state"  # origins
MIN_EXPLAINED = 0.9  # share of the mean square change of the temperature
MAX_RATIO = 10.0  # of the unexplained share to the smallest one
MIN_CHANGE = 1e-3  # K rms; smaller changes of the temperature are ignored
VALID_NAME = re.compile(rf"({AGE}|{CONTACT}|{TEMPERATURE}|{UNKNOWN})(_[1-9][0-9]?)?")


def numbered(origins: Sequence[str]) -> tuple[str, ...]:
    """Return distinct names: an origin that occurs several times is numbered from 1."""
    total, number, names = Counter(origins), Counter[str](), []
    for origin in origins:
        number[origin] += 1
        names.append(f"{origin}_{number[origin]}" if total[origin] > 1 else origin)
    return tuple(names)


def checked_names(names: Sequence[str], count: int) -> tuple[str, ...]:
    """Return the names of memories; without names their origin is unknown.

    Raises UserError for invalid names and for a wrong number of them.
    """
    if not names:
        return numbered([UNKNOWN] * count)
    valid = all(isinstance(name, str) and VALID_NAME.fullmatch(name) for name in names)
    if not valid or len(set(names)) != count or len(names) != count:
        raise LawError(f"names = {list(names)!r:.60}: must be {count} different names of memories")
    return tuple(names)


def memory_texts(names: Sequence[str], rate_per_length: np.ndarray, rate: np.ndarray) -> list[str]:
    """Return the name, role, length and time of each memory. Rates: shape (loads, memories)."""
    with np.errstate(divide="ignore"):
        ranges = zip(1.0 / rate_per_length.T, 1.0 / rate.T, strict=True)
    return [
        f"{name} ({f'z_{k}' if k else 'g, a factor of mu'}): length {_ends(lengths)} m, "
        f"time {_ends(times)} s"
        for k, (name, (lengths, times)) in enumerate(zip(names, ranges, strict=True))
    ]


def _ends(values: np.ndarray) -> str:
    ends = dict.fromkeys(f"{end:.3g}" for end in (values.min(), values.max()))
    return " ... ".join(ends).replace("inf", "infinite")


def origins(
    motions: Sequence[Transient], responses: Sequence[Sequence[np.ndarray]]
) -> tuple[list[str], str]:
    """Return the origin of each memory, and the evidence in words.

    responses : for each memory and motion the columns of its response, shape (rows, columns); those
    of a response without memory come first.
    """
    without_heat = [AGE] + [CONTACT] * (len(responses) - 2)
    known = [motion.known & np.isfinite(motion.heating) for motion in motions]
    if not any(mask.any() for mask in known):
        return without_heat, ""
    heating = np.concatenate([m.heating[mask] for m, mask in zip(motions, known, strict=True)])
    left = [
        _mean_square_left(heating, [rows[mask] for rows, mask in zip(response, known, strict=True)])
        for response in responses
    ]
    if not left[0] > MIN_CHANGE**2:
        return without_heat, "the temperature of the contact follows the velocity"
    explained = 1.0 - np.array(left[1:]) / left[0]
    unexplained = 1.0 - explained
    thermal = (explained >= MIN_EXPLAINED) & (unexplained <= MAX_RATIO * unexplained.min())
    shares = ", ".join(f"{100.0 * max(share, 0.0):.0f} %" for share in explained)
    evidence = f"they explain {shares} of the mean square change of the contact temperature"
    if not thermal.any():
        evidence += ": none follows the heating"
    names = zip(thermal, without_heat, strict=True)
    return [TEMPERATURE if is_thermal else name for is_thermal, name in names], evidence


def _mean_square_left(values: np.ndarray, columns: Sequence[np.ndarray]) -> float:
    """Return the mean square of values that a least-squares fit of columns leaves."""
    matrix = np.concatenate(columns)
    residual = values - matrix @ np.linalg.lstsq(matrix, values)[0]
    return float(np.mean(residual**2))
