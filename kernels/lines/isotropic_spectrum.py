"""The measured power spectrum of an isotropic rough surface, as power laws between its rows.

C_2D(q) is normalised over the plane, int C_2D d^2q = 2 pi int q C_2D dq = h^2. The equivalent line
has pi q C_2D, and a straight cut 2 int_q^inf C_2D(k) k dk/sqrt(k^2 - q^2), both over both signs of
q (P. R. Nayak, J. Lubr. Technol. 93, 398 (1971), doi:10.1115/1.3451608, for the cut).
"""

from typing import NamedTuple

import numpy as np

from ..root_search import root_between

ROW_TOLERANCE = 1e-9  # relative, at both ends of a table
TAIL_DECADES = 16  # beyond the table of a cut, where its last power law continues
TAIL_STEPS = 4  # intervals per decade of the tail
NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)


class IsotropicSpectrum(NamedTuple):
    """C_2D(q) of a surface: power laws between rows, and zero outside of them."""

    q: tuple[float, ...]  # rad per unit of length, ascending
    density: tuple[float, ...]  # C_2D > 0, in the fourth power of that unit

    def at(self, q: np.ndarray) -> np.ndarray:
        """Return C_2D at wave numbers q > 0."""
        low, high = self.q[0] * (1.0 - ROW_TOLERANCE), self.q[-1] * (1.0 + ROW_TOLERANCE)
        between = np.exp(np.interp(np.log(q), np.log(self.q), np.log(self.density)))
        return np.where((low <= q) & (q <= high), between, 0.0)

    def moments_below(self, q: np.ndarray | float) -> tuple[np.ndarray, np.ndarray]:
        """Return mean square height and mean square gradient of the waves up to each q."""
        rows, density = np.array(self.q), np.array(self.density)
        log_rows = np.log(rows)
        exponents = np.diff(np.log(density)) / np.diff(log_rows)
        log_q = np.log(np.clip(q, rows[0], rows[-1]))
        last = np.clip(np.searchsorted(log_rows, log_q, side="right") - 1, 0, exponents.size - 1)
        moments = []
        for power in (0.0, 2.0):
            scale, slope = 2.0 * np.pi * rows ** (2.0 + power) * density, exponents + 2.0 + power
            whole = scale[:-1] * _growth(slope, np.diff(log_rows))
            before = np.concatenate([[0.0], np.cumsum(whole)])
            moments.append(
                before[last] + scale[last] * _growth(slope[last], log_q - log_rows[last])
            )
        return moments[0], moments[1]

    def wave_number_of_slope(self, slope: float) -> float:
        """Return the wave number up to which the waves have this rms gradient.

        Raises ValueError for a gradient above that of the whole table.
        """
        most = float(np.sqrt(self.moments_below(self.q[-1])[1]))
        if not 0.0 < slope <= most:
            raise ValueError(f"is more than {most:.4g}, that of all waves, which")

        def excess(log_q: float) -> float:
            return float(np.sqrt(self.moments_below(np.exp(log_q))[1])) - slope

        low, high = np.log(self.q[0]), np.log(self.q[-1])
        return float(np.exp(root_between(excess, float(low), float(high))))


def _growth(exponent: np.ndarray, log_ratio: np.ndarray) -> np.ndarray:
    """Return int x^(exponent - 1) dx from 1 to exp(log_ratio)."""
    rise = exponent * log_ratio
    small = np.abs(rise) < 1e-9
    return log_ratio * np.where(small, 1.0, np.expm1(rise) / np.where(small, 1.0, rise))


def isotropic_of_equivalent(q: np.ndarray, density: np.ndarray) -> np.ndarray:
    """Return the C_2D of the surface whose equivalent line has a density over both signs of q."""
    return density / (np.pi * q)


def isotropic_of_cut(q: np.ndarray, density: np.ndarray) -> np.ndarray:
    """Return the C_2D of the isotropic surface whose straight cuts have a density.

    q, density : of the cut, over both signs of q, shape (n,). The inverse Abel transform

        C_2D(k) = -(1/pi) int_k^inf C'(q) dq/sqrt(q^2 - k^2),    q = k cosh t,

    uses power laws between the rows; the last one continues beyond the last row. For a density that
    no isotropic surface has, values are not positive.
    """
    exponents = np.diff(np.log(density)) / np.diff(np.log(q))
    tail = q[-1] * np.geomspace(1.0, 10.0**TAIL_DECADES, TAIL_DECADES * TAIL_STEPS + 1)
    with np.errstate(all="ignore"):
        edges, starts = np.concatenate([q[:-1], tail]), np.concatenate([q[:-1], tail[:-1]])
        exponents = np.concatenate([exponents, np.full(tail.size - 1, exponents[-1])])
        levels = density[-1] * (tail[:-1] / q[-1]) ** exponents[-1]
        levels = np.concatenate([density[:-1], levels])
        surface = np.empty(q.size)
        for row, k in enumerate(q):
            t = np.arccosh(np.maximum(edges[row:] / k, 1.0))
            half = 0.5 * np.diff(t)[:, None]
            along = k * np.cosh(t[:-1, None] + half * (1.0 + NODES))
            ratio = along / starts[row:, None]
            fall = -exponents[row:, None] * levels[row:, None] * ratio ** exponents[row:, None]
            surface[row] = np.sum(half * WEIGHTS * fall / along) / np.pi
    return surface
