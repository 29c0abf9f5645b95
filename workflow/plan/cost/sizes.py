"""Seconds of the typical machine over the number of samples of a line."""

from typing import NamedTuple

import numpy as np

from ..problems import Numbers


class SecondsBySize(NamedTuple):
    """Seconds per call over the number of samples: a power law between measured sizes."""

    sizes: tuple[float, ...]  # increasing
    seconds: tuple[float, ...]

    def __call__(self, size: Numbers) -> Numbers:
        """Return the seconds for ``size`` samples: a call takes some, many in proportion."""
        between = np.interp(np.log(size), np.log(self.sizes), np.log(self.seconds))
        return np.exp(between) * np.maximum(1.0, size / self.sizes[-1])


# One core of the machine of the measurements, busy as it was.
DRAW = SecondsBySize(  # phases, two FFTs
    (3e2, 1.2e3, 4e3, 8e3, 2e4, 6e4, 4e5), (2.7e-5, 3.7e-5, 7.2e-5, 1.25e-4, 3.9e-4, 1.8e-3, 1.8e-2)
)
SWEEP = SecondsBySize((4e2, 2e3, 2e4, 2e5), (5.1e-6, 1.0e-5, 7.2e-5, 7.6e-4))  # over all samples
STEP = SecondsBySize((6e1, 2e3, 2e4, 2e5), (3.4e-7, 6.8e-6, 6.8e-5, 7.2e-4))  # over all samples
