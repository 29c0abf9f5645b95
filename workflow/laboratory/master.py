"""One table of moduli from sweeps at several temperatures, with a description of the shifts."""

import math
from typing import NamedTuple

import numpy as np

from ...kernels import Arrhenius, ShiftTable, Wlf
from ..ground import UserError
from ..study import Moduli
from .estimate import Estimate
from .sentences import shown
from .shift_fit import ShiftFit, fit_shifts
from .superposition import Superposition, superposed

MAX_RMS_RESIDUAL = 0.15  # largest relative rms residual of G* that is accepted


class Shifting(NamedTuple):
    """Options of a master curve."""

    reference: float | None = None  # °C; None: the temperature of the middle sweep
    law: str | None = None  # one of SHIFT_KEYS; None: the law that fits best
    vertical: bool = False  # whether moduli are shifted too


class MasterCurve(NamedTuple):
    """Sweeps shifted to one temperature."""

    moduli: Moduli  # with the temperatures of the sweeps
    keys: tuple[str, ...]  # lines for [material] of a study
    temperatures: np.ndarray  # °C, ascending, shape (sweeps,)
    shift: Superposition
    fit: ShiftFit


def master_curve(name: str, measured: Moduli, options: Shifting) -> MasterCurve:
    """Return moduli shifted to one temperature.

    name : name of the file, for messages. Raises UserError for a reference outside the sweeps, for
    sweeps that do not overlap or do not form one curve, and for a law that they do not determine.
    """
    assert measured.temperatures is not None
    temperatures = np.unique(measured.temperatures)
    reference = (
        float(temperatures[temperatures.size // 2])
        if options.reference is None
        else options.reference
    )
    if not temperatures[0] <= reference <= temperatures[-1]:
        raise UserError(
            f"--reference {reference:g}: must lie within the sweeps, {temperatures[0]:g} to "
            f"{temperatures[-1]:g} °C"
        )
    masks = [measured.temperatures == t for t in temperatures]
    sweeps = [(measured.omega[rows], measured.values[rows]) for rows in masks]
    place = int(np.argmin(np.abs(temperatures - reference)))
    try:
        shift = superposed(temperatures, sweeps, place, options.vertical)
        fit = fit_shifts(temperatures, shift.decades, shift.covariance, reference, options.law)
    except ValueError as error:
        raise UserError(f"prony {name}: {error}") from None
    if shift.rms > MAX_RMS_RESIDUAL:
        raise UserError(
            f"prony {name}: no shifts bring the sweeps onto one curve: "
            f"the residual is {100 * shift.rms:.2g} % of the moduli. a_T alone does not describe "
            f"this material{'' if options.vertical else ' (try --vertical)'}, or the columns are "
            "not those of the moduli; give --columns"
        )
    omega, values = measured.omega.copy(), measured.values.copy()
    for rows, across, up in zip(masks, fit.decades, shift.vertical, strict=True):
        omega[rows] *= 10.0**across
        values[rows] *= 10.0**up
    order = np.argsort(omega, kind="stable")
    law_text, key = _law_texts(f"{reference:g}", fit)
    lines = (
        *measured.description,
        *_shift_lines(temperatures, reference, shift, fit, options),
        law_text,
    )
    moduli = Moduli(omega[order], values[order], lines, measured.temperatures[order])
    keys = key, f"temperature = {reference:g}"
    return MasterCurve(moduli, keys, temperatures, shift, fit)


def _shift_lines(
    temperatures: np.ndarray,
    reference: float,
    shift: Superposition,
    fit: ShiftFit,
    options: Shifting,
) -> list[str]:
    """Return a description of the shifts, in sentences."""
    lines = [
        f"{temperatures.size} sweeps at {temperatures[0]:g} ... {temperatures[-1]:g} °C, shifted "
        f"to {reference:g} °C; one Prony series of all leaves {100 * shift.rms:.2g} % rms"
    ]
    both = np.stack([fit.decades, shift.errors, shift.vertical, shift.vertical_errors], axis=1)
    for temperature, (across, error, up, other) in zip(temperatures, both.tolist(), strict=True):
        line = f"  {temperature:g} °C: log10 a_T = {shown(Estimate(across, error))}"
        if options.vertical:
            line += f", log10 b_T = {shown(Estimate(up, other))}"
        lines.append(line)
    if options.vertical:
        lines.append("a study has no key for b_T: its moduli are those at the reference")
    return lines


def _law_texts(at: str, fit: ShiftFit) -> tuple[str, str]:
    """Return the law of the shifts in a sentence, and as a key of a study. at : reference, °C."""
    law = fit.law
    if isinstance(law, Wlf):
        c1, c2 = Estimate(law.c1, fit.errors[0]), Estimate(law.c2, fit.errors[1])
        text = (
            f"WLF: c1 = {shown(c1)}, c2 = {shown(c2)} K, which is VFT with B = "
            f"{law.c1 * law.c2 * math.log(10.0):.4g} K, T_0 = {law.reference - law.c2:.4g} °C"
        )
        key = f"wlf = {{c1 = {law.c1:.5g}, c2 = {law.c2:.5g}, reference = {at}}}"
    elif isinstance(law, Arrhenius):
        energy = Estimate(law.activation_energy, *fit.errors).times(1e-3)
        text = f"Arrhenius: E_a = {shown(energy)} kJ/mol"
        key = f"arrhenius = {{activation_energy = {law.activation_energy:.5g}, reference = {at}}}"
    else:
        assert isinstance(law, ShiftTable)
        rows = [f"[{t:g}, {decades:.5g}]" for t, decades in law.rows]
        text = (
            "shifts: the table itself, linear in between, as no law fits all of them. A study "
            "reads the same table from a text file by the key shifts_file"
        )
        return text, f"shifts = [{', '.join(rows)}]"
    warning = "" if fit.holds else ", more than its error: use --law shifts"
    return f"{text}; it deviates from the shifts by up to {fit.worst:.2g} decades{warning}", key
