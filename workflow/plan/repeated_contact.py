"""Memory of the first contact that a trace meets again after one period of the line or map.

A programme that starts "relaxed" or "fresh" imprints its first contact on every branch that is not
carried along from the start (kernels/scene/carried.py). A branch that outlives the time of one
period still holds the imprint when the motion has covered a period, and friction repeats it. Steady
sliding and motion about one place leave no such imprint.
"""

import math

from ...kernels import carried_branches, programme_extent
from ..simulate import Problem


def remembered_share(problem: Problem) -> float:
    """Return the share of its imprint that the slowest imprinted branch holds after a period.

    It is exp(-L/(v t)) at the highest speed v of the programme; 0 if the motion covers no period,
    if it starts with steady sliding, or for elements that only have a dashpot. For a line pulled by
    a drive, the motion of the drive is used.
    """
    spectrum, programme = problem.spectrum, problem.programme
    if problem.start == "steady":
        return 0.0
    covered, fastest = programme_extent(programme)
    if covered <= problem.elements:
        return 0.0
    carried = None
    if problem.drive is None:
        carried = carried_branches(problem.start, spectrum, programme, problem.elements)
    times = set(spectrum.times) - set(carried.spectrum.times if carried else ())
    return math.exp(-problem.elements / (fastest * max(times))) if times else 0.0
