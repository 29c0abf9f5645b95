"""Print errors of scenes against known answers, under refinement: table of docs/verification.md.

    python -m tests.tools.verification

The tests check bounds of these errors; here they are measured.
"""

from collections.abc import Callable

import numpy as np

from elastomer_friction.kernels.motion.legs import Slide
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum
from tests.convergence import observed_order
from tests.kernels.branches.test_dissipation import errors_in_full_contact
from tests.kernels.scene.given import MATERIALS, PRONY, SOLID, a_line, trace
from tests.kernels.scene.test_energy import missing_work
from tests.kernels.scene.test_known_answers import errors_of_moduli, relaxation_errors
from tests.kernels.scene.test_march import after_a_jump, errors_over_time, gaps_of_schemes


def sinusoid(name: str, refinements: np.ndarray) -> np.ndarray:
    """Return errors of steady friction in full contact, against the loss modulus."""
    return errors_in_full_contact(MATERIALS[name], 5.0, refinements)


def oscillation(name: str, refinements: np.ndarray) -> np.ndarray:
    """Return errors of G* by small oscillations in full contact, at two frequencies."""
    return errors_of_moduli(MATERIALS[name], refinements)


def closing_work(refinements: np.ndarray) -> np.ndarray:
    """Return the closing work over the dissipated energy, of Kelvin elements."""
    return missing_work("kelvin", "slide, hold, slide", refinements, 3)


def to_kelvin(glass: np.ndarray) -> np.ndarray:
    """Return the relative difference of mu from that of a Kelvin element. glass : G_g/G."""
    line, programme = a_line(64, 0.7, 4, 0), (Slide(2.0, 0.25),)
    kelvin = trace(line, programme, KELVIN)["trace_mu"][0]
    materials = (Spectrum((g,), (1.0 / g,), 0.0) for g in glass)
    actual = [trace(line, programme, material)["trace_mu"][0] for material in materials]
    return np.array(actual)[:, None] / kelvin - 1.0


def against_march() -> float:
    """Return the largest difference of mu of Kelvin elements between general path and march."""
    (mu, _), (marched, _) = after_a_jump("exponential", 1.6, 600)
    return float(np.abs(mu - marched).max())


def row(name: str, refinements: np.ndarray, errors: np.ndarray) -> None:
    """Print a row: rms errors over the cases, and the observed order of convergence."""
    rms = np.sqrt(np.mean(np.square(errors), axis=1))
    shown = " ".join(f"{error:.1e}" for error in rms)
    steps = " ".join(f"{r:g}" for r in refinements)
    print(f"| {name} | {steps} | {shown} | {observed_order(refinements, errors):.2f} |", flush=True)


ROWS: dict[str, tuple[Callable[[str, np.ndarray], np.ndarray], tuple[int, ...]]] = {
    "full-contact sinusoid": (sinusoid, (1, 2, 4, 8, 16)),
    "G* by oscillation": (oscillation, (4, 8, 16)),
    "mu(t)": (errors_over_time, (4, 8, 16, 32)),
}


def main() -> None:
    """Print all figures as tables."""
    print("| check | m | error | order |\n|---|---|---|---|")
    for check, (measure, refinements) in ROWS.items():
        for name in MATERIALS:
            row(f"{check}, {name}", np.array(refinements), measure(name, np.array(refinements)))
    m = np.array([2, 4, 8, 16])
    for name, spectrum in (("solid", SOLID), ("prony", PRONY)):
        row(f"relaxation, {name}", m, relaxation_errors(spectrum, m))
        row(f"both schemes, {name}", 4 * m, gaps_of_schemes(name, 4 * m, 2))
        row(f"missing work, {name}", 2 * m, missing_work(name, "reversal", 2 * m, 3))
    row("closing work, kelvin", 2 * m, closing_work(2 * m))
    glass = 10.0 ** np.arange(1, 7)
    row("to Kelvin (G_g/G)", glass, to_kelvin(glass))
    print(f"Kelvin, general path against march: {against_march():.1e}")


if __name__ == "__main__":
    main()
