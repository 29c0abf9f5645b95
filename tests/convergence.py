"""Measurement of orders of convergence."""

import numpy as np


def observed_order(refinements, errors) -> float:
    """Return the order p of |error| ~ refinement^-p, by regression over all refinements.

    errors : shape (refinements, cases). The error of a refinement is the rms over the cases, e.g.
    offsets of the grid, as a single offset may have an error of zero by chance.
    """
    rms = np.sqrt(np.mean(np.square(errors), axis=1))
    return -float(np.polyfit(np.log(refinements), np.log(rms), 1)[0])
