"""Wave numbers of a sampled square, and the stiffness of a half-space over them.

Arrays over modes are those of a real two-dimensional Fourier transform: shape (rows, n//2 + 1).
Source: K. L. Johnson, Contact Mechanics (Cambridge, 1985), ch. 13; p(q) = -(|q|/2) E* u(q).
"""

import numpy as np


def wave_numbers(shape: tuple[int, int], steps_per_spacing: int) -> tuple[np.ndarray, np.ndarray]:
    """Return (q_y as a column, q_x >= 0 as a row) for maps of a shape, in 1/dx."""
    scale = 2.0 * np.pi * steps_per_spacing
    return scale * np.fft.fftfreq(shape[0])[:, None], scale * np.fft.rfftfreq(shape[1])[None, :]


def half_space_stiffness(shape: tuple[int, int], steps_per_spacing: int) -> np.ndarray:
    """Return |q|/2, the stiffness of a relaxed half-space for every mode, in E* h/dx per h."""
    return 0.5 * np.hypot(*wave_numbers(shape, steps_per_spacing))


def two_sided(shape: tuple[int, int]) -> np.ndarray:
    """Return the number of two-sided modes for each q_x >= 0, shape (n//2 + 1,)."""
    count = np.full(shape[1] // 2 + 1, 2.0)
    count[0] = 1.0
    if shape[1] % 2 == 0:
        count[-1] = 1.0
    return count
