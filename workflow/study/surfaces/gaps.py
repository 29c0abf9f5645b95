"""Samples that are missing, in lines as they were measured: counted, filled in or left out."""

import numpy as np

from ...ground import UserError
from ...text_tables import missing_code

GAPS = ("refuse", "fill", "drop")
MOST_FILLED = 0.5  # of the samples of a line that may be filled in


def without_gaps(what: str, heights: np.ndarray, gaps: str) -> tuple[np.ndarray, str]:
    """Return lines without missing samples, and in words what was done; "" where none was missing.

    heights : shape (lines, n); NaN, and codes such as -9999, are missing samples. gaps : one of
    GAPS. ``fill`` draws a straight line between the samples on either side, or goes on with the
    last one at an end; ``drop`` leaves out the lines that have any. what : begins a message.

    Raises UserError where samples are missing and nobody says what to do, where too few are left
    to fill in from, and where no line would be left.
    """
    code = missing_code(heights)
    gone = ~np.isfinite(heights)
    said = f"{int(gone.sum())} of {heights.size} samples"
    if code is not None:
        gone |= heights == code.value
        said = (
            f"{int(gone.sum())} of {heights.size} samples ({code.times} of {code.value:g}, "
            f"{code.spreads:.2g} times the spread of the others)"
        )
    if not gone.any():
        return heights, ""
    lines = gone.any(axis=1)
    place = f" in {int(lines.sum())} of {lines.size} lines" if lines.size > 1 else ""
    if gaps == "refuse":
        row, sample = np.argwhere(gone)[0]
        raise UserError(
            f"{what}: {said} are missing{place}, the first is sample {sample + 1} of line "
            f'{row + 1}: surface.gaps = "fill" fills them in by straight lines, "drop" leaves '
            "their lines out"
        )
    if gaps == "drop":
        if lines.all():
            raise UserError(
                f'{what}: {said} are missing{place}: surface.gaps = "drop" leaves no line; "fill" '
                "fills them in by straight lines"
            )
        return heights[~lines], f"{said} are missing{place}, which were left out"
    return _filled(what, heights, gone), f"{said} were missing{place} and were filled in"


def _filled(what: str, heights: np.ndarray, gone: np.ndarray) -> np.ndarray:
    found, index = heights.copy(), np.arange(heights.shape[1])
    for row in np.flatnonzero(gone.any(axis=1)):
        known = ~gone[row]
        if known.mean() < MOST_FILLED:
            raise UserError(
                f"{what}: line {row + 1} of {len(heights)} holds {int(known.sum())} of "
                f'{index.size} samples, too few to fill in: surface.gaps = "drop" leaves it out'
            )
        found[row, ~known] = np.interp(index[~known], index[known], heights[row, known])
    return found
