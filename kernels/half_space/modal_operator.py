"""The operator A of a half-space, from pressures to displacements, and workspace for contacts."""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel

STENCIL_CENTRE = 5.0  # its neighbours are -1; chosen by trial, for any load


class Operator(NamedTuple):
    """A over the modes, and workspace for transforms and for a solution (contact.py)."""

    compliance: np.ndarray  # shape (rows, n//2 + 1); 0 for the mean
    stencil_scale: float  # makes the stencil nearly the inverse of A
    modes: np.ndarray  # complex
    fields: np.ndarray  # shape (3, rows, n)
    free: np.ndarray  # shape (rows n,), int64: samples whose p may change
    listed: np.ndarray  # shape (5, rows n): values at these samples

    @classmethod
    def of(cls, stiffness: np.ndarray, n: int) -> "Operator":
        """Return the operator of a stiffness over the modes of maps (rows, n).

        The mean is not used. Raises ValueError if another mode has no positive stiffness.
        """
        inner = stiffness.ravel()[1:]
        if not np.all(inner > 0.0):
            raise ValueError("stiffness must be positive for every mode but the mean")
        compliance = np.zeros_like(stiffness)
        compliance.ravel()[1:] = 1.0 / inner
        return cls.inverse(compliance, n)

    @classmethod
    def inverse(cls, compliance: np.ndarray, n: int) -> "Operator":
        """Return the operator of a compliance over the modes, 0 for the mean."""
        rows = compliance.shape[0]
        modes, fields = np.empty(compliance.shape, complex), np.empty((3, rows, n))
        free, listed = np.empty(rows * n, np.int64), np.empty((5, rows * n))
        return cls(compliance, _stencil_scale(compliance, n), modes, fields, free, listed)

    def of_compliance(self, compliance: np.ndarray) -> "Operator":
        """Return the operator of another compliance, in the same workspace."""
        scale = _stencil_scale(compliance, self.fields.shape[2])
        return self._replace(compliance=compliance, stencil_scale=scale)

    def coarse(self) -> "Operator":
        """Return the operator of every second sample along each axis; a single row stays."""
        rows, n = self.fields.shape[1:]
        half = max(rows // 2, 1)
        k_y = np.fft.fftfreq(half, 1.0 / half).astype(np.int64)
        return Operator.inverse(self.compliance[k_y, : n // 4 + 1], n // 2)

    def displaced(self, p: np.ndarray, out: np.ndarray) -> np.ndarray:
        """Fill out, shape (rows, n), with A p, and return it."""
        return convolved(p, self.compliance, self.modes, out)


def convolved(
    p: np.ndarray, compliance: np.ndarray, modes: np.ndarray, out: np.ndarray
) -> np.ndarray:
    """Fill out, shape (rows, n), with the displacements of p, and return it.

    compliance : real or complex, over the modes. modes : workspace, complex, of the same shape.
    """
    np.fft.rfft(p, axis=1, out=modes)
    if p.shape[0] > 1:
        np.fft.fft(modes, axis=0, out=modes)
    _multiply(modes, compliance)
    if p.shape[0] > 1:
        np.fft.ifft(modes, axis=0, out=modes)
    return np.fft.irfft(modes, p.shape[1], axis=1, out=out)


@kernel
def _multiply(modes, compliance):
    """Multiply the modes in place; numpy would first make a real compliance complex."""
    for y in range(modes.shape[0]):
        for x in range(modes.shape[1]):
            modes[y, x] *= compliance[y, x]


def _stencil_scale(compliance: np.ndarray, n: int) -> float:
    """Return the factor that makes the stencil 1/A for waves of four samples along x."""
    return float(1.0 / ((STENCIL_CENTRE - 2.0) * compliance[0, max(1, n // 4)]))
