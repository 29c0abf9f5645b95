"""Fit all steps of some records, and what they determine together."""

from typing import NamedTuple

from .errors import Estimate
from .jumps import fit_slope
from .record import Record
from .speeds import Known, Rates, fit_rates
from .step_fit import StepFit, fit_step
from .steps import steps_of


class Fit(NamedTuple):
    """What some records determine of the kinetic law, and of state laws."""

    steps: list[StepFit]  # by eq. 6, which is Ruina's law
    ageing: list[StepFit]  # the same steps by Dieterich's law
    rates: Rates | None  # None where no step determines its rate
    slope: Estimate  # grad z
    known: Known


def fit_records(records: list[Record], known: Known, window: float | None = None) -> Fit:
    """Return the fit of all velocity steps in some records.

    known : what is known from elsewhere, ``Known()`` for nothing. window : seconds after each step
    that are looked at, at most. Raises UserError for a record without a step, or with too few
    samples after it.
    """
    steps = [step for record in records for step in steps_of(record, window)]
    fits = [fit_step(step) for step in steps]
    return Fit(
        steps=fits,
        ageing=[fit_step(step, "dieterich") for step in steps],
        rates=fit_rates(fits, known),
        slope=fit_slope(fits),
        known=known,
    )
