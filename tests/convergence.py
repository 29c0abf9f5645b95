"""Measuring orders of convergence."""

import numpy as np


def observed_order(refinements, errors) -> float:
    """Return the order p of |error| ~ refinement^-p, by regression over all refinements.

    errors : shape (refinements, cases). The rms over the cases, here offsets of the grid,
    stands for the error of a refinement: a single offset may hit a lucky zero.
    """
    rms = np.sqrt(np.mean(np.square(errors), axis=1))
    return -float(np.polyfit(np.log(refinements), np.log(rms), 1)[0])
