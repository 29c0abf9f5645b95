"""The meanings of all variables by sections: what the reference page is made of."""

from collections.abc import Mapping

from . import of_programmes, steps

SECTIONS: dict[str, Mapping[str, str]] = {
    "Every result": steps.GENERAL,
    "Steady sliding (quantity `steady`)": steps.STEADY,
    "The jump (quantity `jump`)": steps.JUMP,
    "Relaxation after the velocity step (quantity `relaxation`)": steps.RELAXATION,
    "Exponents, one for each H (quantity `relaxation`)": steps.EXPONENTS,
    "Fits beyond eq. 6 (quantity `models`)": steps.MODELS,
    "Along a programme (quantity `trace`)": of_programmes.TRACE,
    "Peaks, holds and loops (`peak`, `healing`, `loop`, `cycle_mean`)": of_programmes.EVENTS,
    "Rate and state (quantity `rate_state`)": of_programmes.RATE_STATE,
    "Energy and lengths of contacts (quantities `energy`, `contact_lengths`)": of_programmes.ENERGY,
    "A single line (quantities `snapshots`, `state`)": of_programmes.ALONE,
}
