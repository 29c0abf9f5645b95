"""Stretches of the springs of single branches, in both forms of a material.

The spring of branch b is stretched by e_b = u - v_b, where v_b is the displacement of its dashpot,
and carries the stress g_b e_b. Equal Laplace transforms of both forms for a body with this past,
without force from then on, give at the poles of each of them

    y_k = J_k u - J_k sum_b g_b t_b e_b/(lambda_k - t_b),
    v_b = sum_k lambda_k y_k/(lambda_k - t_b).
"""

from typing import Any

import numpy as np

from .relaxed import RelaxationForm
from .retardation import merged_branches
from .spectrum import Spectrum


def branch_stretches(
    spectrum: Spectrum, form: Any, memory: np.ndarray, u: np.ndarray
) -> np.ndarray:
    """Return the stretch of each branch's spring, slowest branch first, shape (B, n), in h.

    form, memory : of a material without a dashpot and with this spectrum. u (n,) : displacements.
    """
    moduli, times = merged_branches(spectrum)
    if isinstance(form, RelaxationForm):
        return memory[:-1] / moduli[:, None]
    shares = form.times / (form.times - times[:, None])
    return u - np.einsum("bk,kn->bn", shares, memory)


def stretch_branches(
    spectrum: Spectrum, form: Any, memory: np.ndarray, stretches: np.ndarray
) -> None:
    """Stretch the springs of the slowest branches; memory : relaxed, changed in place.

    spectrum : of these branches only. form, memory : of the whole material. stretches : as returned
    by ``branch_stretches``.
    """
    moduli, times = merged_branches(spectrum)
    if isinstance(form, RelaxationForm):
        memory[: moduli.size] = moduli[:, None] * stretches
        return
    shares = form.compliances[:, None] * moduli * times / (form.times[:, None] - times)
    memory -= np.einsum("kb,bn->kn", shares, stretches)
