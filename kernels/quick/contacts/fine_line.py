"""A smooth line between its samples: where it can be low, how high it is there, and the gaps."""

import numpy as np

from ...compile.jit import kernel
from ...rheology.law import NEGLIGIBLE
from ..steady.carry import Gaps
from ..steady.spans import SPAN

STRIP = 64  # intervals that are asked at once whether any is marked


@kernel
def curvatures(z, slope, spacing):
    """Return z'' (in h/dx^2) from heights and slopes, shape (n,); of fourth order."""
    n = z.size
    found = np.empty(n)
    for j in range(n):
        k, i = j + 1 if j + 1 < n else 0, j - 1 if j > 0 else n - 1
        bend = (z[k] - z[j]) - (z[j] - z[i])
        found[j] = 2.0 * bend / spacing**2 - 0.5 * (slope[k] - slope[i]) / spacing
    return found


@kernel
def lowest_between(z, slope, j, spacing):
    """Return a height that the line does not fall below in the interval (j, j + 1)."""
    k = j + 1 if j + 1 < z.size else 0
    return min(z[j], z[k]) - 0.25 * spacing * (abs(slope[j]) + abs(slope[k]))


@kernel
def mark_touchable(z, slope, spans, state, spacing, margin):
    """Return which intervals elements may touch that come as in a state, and those beside them.

    spans : of the line. state : free displacements w and indentation d on the samples. margin :
    of d.
    """
    n = z.size
    low = np.zeros(n, np.bool_)
    depth = (1.0 + margin) * state.d
    for b in range(n // SPAN + 1):
        if b + 1 < spans.lowest.size and _lowest_in(spans, b, spacing) >= depth:
            continue  # as w <= 0
        for j in range(b * SPAN, min((b + 1) * SPAN, n)):
            if lowest_between(z, slope, j, spacing) - depth < state.w[j]:
                _mark(low, j)
    return low


@kernel
def _lowest_in(spans, b, spacing):
    """Return a height that the line does not fall below between the samples of span b and later."""
    steep = max(spans.steepest[b], spans.steepest[b + 1])
    return min(spans.lowest[b], spans.lowest[b + 1]) - 0.5 * spacing * steep


@kernel
def _mark(low, j):
    """Mark an interval and one on either side."""
    low[j] = low[j - 1] = low[j + 1 if j + 1 < low.size else 0] = True  # low[-1] is the last


@kernel
def marked(low, wide):
    """Return the marked intervals, increasing, and more, so that they come ``wide`` together."""
    at = np.empty(low.size, np.int64)
    found = until = 0  # all that is wanted before ``until`` has been found
    for first in range(0, low.size, STRIP):
        stop, count = min(first + STRIP, low.size), 0
        for j in range(first, stop):
            count += low[j]
        for j in range(first, stop if count > 0 else first):
            if low[j] and j >= until:
                until = min(j - j % wide + wide, low.size)
                for k in range(j - j % wide, until):
                    at[found] = k
                    found += 1
    return at[:found].copy()


@kernel
def mark_missed(z, slope, spans, spacing, once, d, at, gaps, fold, low):
    """Mark the intervals that elements touch as they fly over the gaps; return their number.

    spans : of the line. once : what is left of a displacement after an interval. d : indentation.
    at, gaps : as of gaps_of, after a sweep at d.
    """
    missed = 0
    after_span = once**SPAN
    for b in range(gaps.left.size):
        if gaps.left[b] == 1.0:
            continue
        i = min((b + 1) * SPAN, at.size * fold) // fold - 1
        j = (at[i + 1] if i + 1 < at.size else at[0] + z.size) - 1
        u = gaps.entered[b]
        while j > at[i]:
            k = j if j < z.size else j - z.size
            s = k // SPAN
            whole = k == s * SPAN + SPAN - 1 and j - SPAN > at[i] and s + 1 < spans.lowest.size
            if whole and _lowest_in(spans, s, spacing) - d >= after_span * u:
                u = after_span * u if u < -NEGLIGIBLE else 0.0
                j -= SPAN
                continue
            u = once * u if u < -NEGLIGIBLE else 0.0
            if lowest_between(z, slope, k, spacing) - d < u:
                _mark(low, k)
                missed += 1
            j -= 1
    return missed


@kernel
def interpolate(z, slope, curvature, at, spacing, fold):
    """Return (heights, slopes) at ``fold`` points from the beginning of every interval ``at``.

    By the polynomial of fifth degree that has the height, slope and curvature at both ends.
    """
    heights, slopes = np.empty(at.size * fold), np.empty(at.size * fold)
    for i in range(at.size):
        j, k = at[i], at[i] + 1 if at[i] + 1 < z.size else 0
        rise = z[k] - z[j]
        s, t = spacing * slope[j], spacing * slope[k]
        b, c = 0.5 * spacing**2 * curvature[j], 0.5 * spacing**2 * curvature[k]
        p3 = 10.0 * rise - 6.0 * s - 4.0 * t - 3.0 * b + c
        p4 = -15.0 * rise + 8.0 * s + 7.0 * t + 3.0 * b - 2.0 * c
        p5 = 6.0 * rise - 3.0 * s - 3.0 * t - b + c
        z0, s0 = z[j], slope[j]
        r1, r2, r3, r4 = (
            2.0 * b / spacing,
            3.0 * p3 / spacing,
            4.0 * p4 / spacing,
            5.0 * p5 / spacing,
        )
        for q in range(fold):
            y = q / fold
            heights[i * fold + q] = z0 + y * (s + y * (b + y * (p3 + y * (p4 + y * p5))))
            slopes[i * fold + q] = s0 + y * (r1 + y * (r2 + y * (r3 + y * r4)))
    return heights, slopes


@kernel
def gaps_of(law, at, fold, n):
    """Return the Gaps before the spans of fine samples of the intervals ``at`` of n."""
    fine = at.size * fold
    count = (fine + SPAN - 1) // SPAN
    left, within = np.ones(count), np.zeros(count)
    for b in range(count):
        top = min((b + 1) * SPAN, fine)
        i = top // fold - 1
        if top % fold == 0:
            after = at[i + 1] if i + 1 < at.size else at[0] + n
            skipped = (after - at[i] - 1) * fold
            if skipped > 0:
                left[b] = law.decay ** float(skipped)
                if left[b] * left[b] < NEGLIGIBLE:
                    left[b] = 0.0
                within[b] = law.decay * law.stiffness * (1.0 - left[b])
    return Gaps(left, within, np.empty(count))
