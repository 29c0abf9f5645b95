"""Material fitted to moduli: its branches, the quality of the fit, input for other programs."""

from collections.abc import Callable

import numpy as np

from ..ground import UserError
from ..study import Moduli
from .master import MAX_RMS_RESIDUAL
from .prony_fit import PronyFit, fit_prony

MAX_LOSS_RESIDUAL = 0.5  # of G'' in a decade, relative, without a warning
MIN_RELAXED_SHARE = 1e-9  # smallest relaxed modulus over the modulus of the stiffest branch


def fit_material(name: str, measured: Moduli, branches: int | None) -> PronyFit:
    """Fit a material to moduli at one temperature. branches : number, or None for the fewest.

    name : name of the file, for messages. Raises UserError if the residual is too large, or if the
    material has no relaxed modulus to carry a load.
    """
    fit = fit_prony(measured.omega, measured.values, branches)
    where = f"prony {name}"
    stiffest = max((modulus for modulus, _ in fit.branches), default=0.0)
    rms, dense = (f"{100 * value:.2g} %" for value in (fit.rms, fit.dense))
    if fit.dense > MAX_RMS_RESIDUAL:
        raise UserError(
            f"{where}: no Prony series fits: the rms residual of the moduli is {dense}, above "
            f"{100 * MAX_RMS_RESIDUAL:g} %; {measured.description[0]}; "
            "give other --columns or units, and the temperatures of all sweeps"
        )
    if fit.rms > MAX_RMS_RESIDUAL:
        raise UserError(
            f"{where}: {branches} branches are too few: the rms residual of G* is {rms}, and "
            f"{dense} with any number; give more --branches"
        )
    if not fit.branches or fit.shear_modulus < MIN_RELAXED_SHARE * stiffest:
        lacking = "relaxed modulus" if fit.branches else "branches"
        raise UserError(
            f"{where}: the best fit has no {lacking}; a study needs the moduli of a rubber"
        )
    return fit


def describe_material(measured: Moduli, fit: PronyFit, requested: int | None) -> list[str]:
    """Return a description of the fit and its quality, in sentences."""
    omega = measured.omega
    lines = [
        f"{omega.size} times, {1.0 / omega[-1]:.3g} ... {1.0 / omega[0]:.3g} s"
        if measured.over_time
        else f"{omega.size} frequencies, {omega[0]:.3g} ... {omega[-1]:.3g} rad/s",
        f"{len(fit.branches)} branches; residual of {'G' if measured.over_time else 'G*'} "
        f"{100 * fit.rms:.2g} % rms, "
        f"{100 * fit.worst:.2g} % at most; relaxation slower than {fit.slowest:.3g} s counts as "
        "complete",
    ]
    ends = (1.0 / omega[0], "s down") if measured.over_time else (omega[0], "rad/s")
    first = f"{ends[0]:.3g} {ends[1]}"
    decades = _per_decade(measured, fit.residual)
    lines.append(
        f"residual per decade from {first}: {', '.join(f'{100 * one:.2g}' for one in decades)} %"
    )
    if decades.max() > MAX_RMS_RESIDUAL:
        lines.append(
            f"warning: the residual exceeds {100 * MAX_RMS_RESIDUAL:g} % in decade "
            f"{decades.argmax() + 1}: omit these rows, or use no result from there"
        )
    losses = _per_decade(measured, fit.loss_residual)
    if losses.max() > MAX_LOSS_RESIDUAL:
        lines.append(
            f"warning: G'' of the fit differs by {100 * losses.max():.2g} % rms in decade "
            f"{losses.argmax() + 1}; friction at these frequencies depends on G''"
        )
    if requested is not None and fit.rms > 2.0 * fit.dense:
        lines.append(
            f"{requested} branches are too few: with more, the residual is "
            f"{100 * fit.dense:.2g} % rms"
        )
    if not fit.determined:
        lines.append(
            f"the data do not determine the relaxed modulus: {fit.least:.3g} ... {fit.most:.3g} "
            f"Pa fit equally well; measure "
            + (f"beyond {ends[0]:.3g} s" if measured.over_time else f"at frequencies below {first}")
        )
    return lines


def _per_decade(measured: Moduli, residual: np.ndarray) -> np.ndarray:
    """Return the rms residual in each decade of frequency with data. residual : shape (n,)."""
    decade = np.floor(np.log10(measured.omega / measured.omega[0]) + 1e-9)
    squares = [np.mean(residual[decade == value] ** 2) for value in np.unique(decade)]
    return np.sqrt(squares)


def _shares(fit: PronyFit) -> tuple[float, list[tuple[float, float]]]:
    """Return the instantaneous modulus G_0 (Pa), and the branches as shares of it."""
    whole = fit.shear_modulus + sum(modulus for modulus, _ in fit.branches)
    return whole, [(modulus / whole, time) for modulus, time in fit.branches]


def _for_abaqus(fit: PronyFit) -> list[str]:
    whole, shares = _shares(fit)
    head = f"** shares of the instantaneous G_0 = {whole:.6g} Pa; g_i, k_i, tau_i in s"
    rows = [f"{share:.6g}, 0, {time:.6g}" for share, time in shares]
    return [head, "*VISCOELASTIC, TIME=PRONY", *rows]


def _for_ansys(fit: PronyFit) -> list[str]:
    whole, shares = _shares(fit)
    head = f"! shares of the instantaneous G_0 = {whole:.6g} Pa; alpha_i, tau_i in s"
    values = [f"TBDATA,{2 * i + 1},{a:.6g},{t:.6g}" for i, (a, t) in enumerate(shares)]
    return [head, f"TB,PRONY,1,1,{len(shares)},SHEAR", *values]


FORMS: dict[str, Callable[[PronyFit], list[str]]] = {
    "study": lambda _: [],
    "abaqus": _for_abaqus,
    "ansys": _for_ansys,
}
