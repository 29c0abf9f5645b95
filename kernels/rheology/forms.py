"""The two forms of a material, by the name of the time scheme that uses each."""

from collections.abc import Callable
from functools import lru_cache

from . import prony, relaxed
from .relaxed import RelaxationForm, relaxation
from .retardation import Retardation, retardation
from .spectrum import Spectrum

Form = Retardation | RelaxationForm
FORMS_BY_SCHEME: dict[str, Callable[[Spectrum], Form]] = {
    prony.PRONY_SCHEME: retardation,
    relaxed.RELAXATION_SCHEME: relaxation,
}


@lru_cache(maxsize=100)
def form_of(spectrum: Spectrum, scheme: str) -> Form:
    """Return the form of a material for a time scheme. Raises ValueError as retardation does."""
    return FORMS_BY_SCHEME[scheme](spectrum)
