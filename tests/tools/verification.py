"""Print how well scenes agree with what is known, refined: the table of docs/verification.md.

    python -m tests.tools.verification

The tests hold bounds on these figures; here they are measured.
"""

from collections.abc import Callable

import numpy as np

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, march, steady_sliding
from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Slide
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum, complex_modulus
from tests.convergence import observed_order
from tests.kernels.branches.test_dissipation import friction
from tests.kernels.scene.given import MATERIALS, PRONY, SOLID, a_line, trace
from tests.kernels.scene.test_energy import missing_work
from tests.kernels.scene.test_follow import errors_over_time, gaps_of_schemes
from tests.kernels.scene.test_known_answers import Q, relaxation_errors, response


def sinusoid(name: str, refinements: np.ndarray) -> np.ndarray:
    """Return errors of steady friction in full contact, against the loss modulus."""
    q, a, rate = 2.0 * np.pi / 32.0, 0.3, 5.0
    modulus = complex_modulus(MATERIALS[name], rate)
    load = 1.5 * a * abs(modulus)
    errors = []
    for m in refinements:
        x = np.arange(32 * m) / m
        line = Line.from_samples(a * np.cos(q * x), -a * q * np.sin(q * x), int(m))
        mu, _ = friction(MATERIALS[name], line, rate / q, load)
        errors.append([mu / (a**2 * q * modulus.imag / (2.0 * load)) - 1.0])
    return np.array(errors)


def oscillation(name: str, refinements: np.ndarray) -> np.ndarray:
    """Return errors of G* by small oscillations in full contact, at two frequencies."""
    errors = np.empty((refinements.size, 2))
    for j, (omega, cycles) in enumerate(((3.0, 6), (30.0, 24))):
        expected = (complex_modulus(MATERIALS[name], omega) - 1.0) * 0.5 * Q**2
        for k, m in enumerate(refinements):
            found = response(MATERIALS[name], omega, m, cycles)
            errors[k, j] = abs(found / expected - 1.0)
    return errors


def closing_work(refinements: np.ndarray) -> np.ndarray:
    """Return the closing work over what is dissipated, of Kelvin elements."""
    return missing_work("kelvin", "slide, hold, slide", refinements, 3)


def to_kelvin(glass: np.ndarray) -> np.ndarray:
    """Return by how much mu of a step at G_g/G differs from that of the Kelvin element."""
    line, programme = a_line(64, 0.7, 4, 0), (Slide(2.0, 0.25),)
    kelvin = trace(line, programme, KELVIN)["trace_mu"][0]
    materials = (Spectrum((g,), (1.0 / g,), 0.0) for g in glass)
    found = [trace(line, programme, material)["trace_mu"][0] for material in materials]
    return np.array(found)[:, None] / kelvin - 1.0


def against_march() -> float:
    """Return the largest difference of mu between the general path and the march, of Kelvin."""
    line = a_line()
    n, m = line.z.size, line.steps_per_spacing
    before, after = (SCHEMES["exponential"](1.0 / (m * v)) for v in (0.5, 0.8))
    state, _ = steady_sliding(before, line.z, 0.3 * n)
    weight, kept = lagged_slope(line.slope, after.lag), np.arange(1, 601)
    mu = march(after, ConstantForce(0.3 * n), line.z, weight, state, kept, np.inf)[0]
    found = trace(line, (Slide(0.5, 1.0 / m), Slide(0.8, 600.0 / m)), KELVIN)["trace_mu"]
    return float(np.abs(found[2:] - mu).max())


def row(name: str, refinements: np.ndarray, errors: np.ndarray) -> None:
    """Print a row: rms errors over the cases, and the order between the refinements."""
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
