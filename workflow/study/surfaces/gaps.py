"""Treatment of missing samples and spikes in measured lines: refused, filled in, left out, kept."""

import numpy as np

from ...ground import UserError
from ..codes import missing_code

GAPS = ("refuse", "fill", "drop")
SPIKES = ("refuse", "fill", "keep")
MIN_KNOWN_SHARE = 0.5  # minimum share of known samples in a line whose gaps are filled in


def marked_gaps(prefix: str, heights: np.ndarray, gaps: str) -> tuple[np.ndarray, str]:
    """Return lines with NaN where samples are missing, and a note on their treatment, or "".

    prefix : start of an error message. heights : shape (lines, n); NaN and codes such as -9999 mark
    missing samples. gaps : one of GAPS; ``drop`` leaves out the lines with missing samples.

    Raises UserError for missing samples if ``gaps`` is ``refuse``, or if no line would remain.
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
    marked = np.where(missing, np.nan, heights)
    return marked, f"{count_text} were missing{place} and were filled in"


def marked_spikes(
    prefix: str, heights: np.ndarray, least: np.ndarray, spikes: str
) -> tuple[np.ndarray, str]:
    """Return lines with NaN at spikes that are to be filled in, and a note on it, or "".

    Both samples of a pair whose heights differ by ``least`` or more are spikes.
    Source: ISO 13473-1:2019, 7.5.

    prefix : start of an error message. heights : shape (lines, n), NaN where samples are missing.
    least : for each line, shape (lines, 1). spikes : one of SPIKES.

    Raises UserError if ``spikes`` is ``refuse`` and a spike lies beside a missing sample, which
    would be filled in from it.
    """
    steep = np.pad(np.abs(np.diff(heights)) >= least, ((0, 0), (1, 1)))
    missing = np.pad(np.isnan(heights), ((0, 0), (1, 1)))
    high, beside = steep[:, 1:] | steep[:, :-1], missing[:, 2:] | missing[:, :-2]
    count_text = f"{int(high.sum())} of {heights.size} samples"
    if spikes == "fill" and high.any():
        return np.where(high, np.nan, heights), f"{count_text} were spikes and were filled in"
    if spikes == "refuse" and (high & beside).any():
        row, sample = np.argwhere(high & beside)[0]
        raise UserError(
            f"{prefix}: {count_text} stand out as spikes, and gaps would be filled in from "
            f"{int((high & beside).sum())} of them, as sample {sample + 1} of line {row + 1}: "
            'surface.spikes = "fill" replaces them by straight lines, "keep" keeps them'
        )
    return heights, ""


def gaps_filled(prefix: str, heights: np.ndarray) -> np.ndarray:
    """Return lines with NaN filled in by straight lines, at the ends by the nearest sample.

    prefix : start of an error message. heights : shape (lines, n). Raises UserError if too few
    samples are known.
    """
    missing = np.isnan(heights)
    filled, index = heights.copy(), np.arange(heights.shape[1])
    for row in np.flatnonzero(missing.any(axis=1)):
        known = ~missing[row]
        if known.mean() < MIN_KNOWN_SHARE:
            raise UserError(
                f"{prefix}: line {row + 1} of {len(heights)} holds {int(known.sum())} of "
                f"{index.size} samples, too few to fill in: leave it out, as surface.gaps = "
                '"drop" does'
            )
        filled[row, ~known] = np.interp(index[~known], index[known], heights[row, known])
    return filled
