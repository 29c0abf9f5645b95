"""The cases of `make bench`: lines, loads and speeds from all over figure 7 at paper scale."""

from typing import NamedTuple

RATIO = 1.2  # v2 / v1


class Row(NamedTuple):
    """One case: a march of so many steps, four relaxation times or more."""

    hurst: float
    elements: int
    m: int  # steps per spacing
    x: float  # v1 tau q_max = pi vbar
    load: float  # Fbar
    steps: int


ROWS = (
    Row(0.7, 1000, 4, 0.09, 1e-3, 8),
    Row(0.7, 5000, 4, 78.0, 0.025, 130),
    Row(0.7, 5000, 4, 78.0, 1.0, 130),
    Row(0.0, 5000, 8, 31.0, 0.03, 13),
    Row(1.0, 5000, 4, 31.0, 1.0, 192),
    Row(0.7, 20000, 4, 9.4, 0.1, 30),
    Row(0.0, 20000, 4, 94.0, 1e-3, 8),
    Row(0.7, 20000, 4, 94.0, 1.0, 148),
    Row(1.0, 20000, 4, 94.0, 1.0, 576),
    Row(0.7, 300, 64, 0.09, 0.1, 10),
    Row(0.7, 300, 1, 9.4, 0.1, 8),
    Row(0.7, 5000, 1, 94.0, 0.1, 37),
    Row(0.5, 5000, 64, 0.09, 1e-3, 10),
)
