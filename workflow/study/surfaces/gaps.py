"""Treatment of missing samples in measured lines: refused, filled in or left out."""

import numpy as np

from ...ground import UserError
from ..codes import missing_code

GAPS = ("refuse", "fill", "drop")
MIN_KNOWN_SHARE = 0.5  # minimum share of known samples in a line whose gaps are filled in


def without_gaps(prefix: str, heights: np.ndarray, gaps: str) -> tuple[np.ndarray, str]:
    """Return lines without missing samples, and a note on their treatment, or "".

    prefix : start of an error message. heights : shape (lines, n); NaN and codes such as -9999 mark
    missing samples. gaps : one of GAPS. ``fill`` interpolates linearly, and repeats the nearest
    sample at the ends; ``drop`` leaves out the lines with missing samples.

    Raises UserError for missing samples if ``gaps`` is ``refuse``, if too few samples are known to
    fill in the others, or if no line would remain.
    """
    code = missing_code(heights)
    missing = ~np.isfinite(heights)
    count_text = f"{int(missing.sum())} of {heights.size} samples"
    if code is not None:
        missing |= heights == code.value
        count_text = (
            f"{int(missing.sum())} of {heights.size} samples ({code.times} of {code.value:g}, "
            f"{code.spreads:.2g} times the spread of the others)"
        )
    if not missing.any():
        return heights, ""
    lines = missing.any(axis=1)
    place = f" in {int(lines.sum())} of {lines.size} lines" if lines.size > 1 else ""
    if gaps == "refuse":
        row, sample = np.argwhere(missing)[0]
        raise UserError(
            f"{prefix}: {count_text} are missing{place}, the first is sample {sample + 1} of line "
            f'{row + 1}: surface.gaps = "fill" fills them in by straight lines, "drop" leaves '
            "their lines out"
        )
    if gaps == "drop":
        if lines.all():
            raise UserError(
                f'{prefix}: {count_text} are missing{place}: surface.gaps = "drop" leaves no line; '
                '"fill" fills them in by straight lines'
            )
        return heights[~lines], f"{count_text} are missing{place}, which were left out"
    return _filled(prefix, heights, missing), f"{count_text} were missing{place} and were filled in"


def _filled(prefix: str, heights: np.ndarray, missing: np.ndarray) -> np.ndarray:
    filled, index = heights.copy(), np.arange(heights.shape[1])
    for row in np.flatnonzero(missing.any(axis=1)):
        known = ~missing[row]
        if known.mean() < MIN_KNOWN_SHARE:
            raise UserError(
                f"{prefix}: line {row + 1} of {len(heights)} holds {int(known.sum())} of "
                f'{index.size} samples, too few to fill in: surface.gaps = "drop" leaves it out'
            )
        filled[row, ~known] = np.interp(index[~known], index[known], heights[row, known])
    return filled
