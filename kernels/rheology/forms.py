"""The two forms of a material, by the name of the time scheme that each of them gives."""

from collections.abc import Callable

from kernels.rheology import prony, relaxed
from kernels.rheology.relaxed import Moduli, relaxation
from kernels.rheology.retardation import Retardation, retardation
from kernels.rheology.spectrum import Spectrum

FORMS: dict[str, Callable[[Spectrum], Retardation | Moduli]] = {
    prony.SCHEME: retardation,
    relaxed.SCHEME: relaxation,
}
