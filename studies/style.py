"""What the figures of several studies share: the names of the two ways to step in time."""

CONVERGED, PAPER_STEP = "", "paper_step"  # groups of a result; the first is the study itself
VARIANTS = {
    CONVERGED: "converged",
    PAPER_STEP: "implicit Euler, one step per $\\Delta x$",
}
