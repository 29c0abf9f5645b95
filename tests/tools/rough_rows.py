"""Print the friction of rough surfaces on both bodies, in the cases of an independent prototype.

    python -m tests.tools.rough_rows [ROW ...]

docs/bodies.md has the table. All surfaces have H = 0.7, and loads are sigma_0/(E* grad z). mu is
divided by grad z, and also by E''(q_max v)/E* if the elastomer is nearly elastic: it then has one
relaxation time with x = v tau q_max = 0.01 for E'' ~ omega, or thirteen branches of together G/50
for E'' ~ omega^s. Errors are standard errors of the mean over surfaces. The third friction of a row
is for lines with C_1D = pi q C_2D also below the roll-off, where lines of the program have a flat
C_1D.
"""

import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from elastomer_friction.kernels import equivalent_amplitudes
from elastomer_friction.kernels.half_space.surface import ring_amplitudes, rms_slope_of
from elastomer_friction.workflow.scene import compute
from elastomer_friction.workflow.study import (
    FOUNDATION,
    HALF_SPACE,
    profile_of_array,
    read_grid_study,
)

HURST, SIDE, HEIGHT, SPEED, MODULUS = 0.7, 1e-3, 1e-6, 1e-2, 1e6  # SI; E* = 4 G
SEED, STEP, SLOW, LOST = 29, 0.2, 0.01, 0.02  # LOST: sum of the branch moduli over G
FINE = 8  # samples per spacing of a map and of an equivalent line


class Rough(NamedTuple):
    """One surface and motion."""

    load: float  # sigma_0/(E* grad z)
    lengths: int  # number of roll-off lengths in a side
    power: float  # s of E'' ~ omega^s; 1: one relaxation time
    maps: int  # number of surfaces
    x: float = SLOW  # v tau q_max
    waves: int = 8  # number of shortest waves in a roll-off length
    whole: bool = False  # F_N = sigma_0 L^2 on the line too, else sigma_0 lambda_r L
    step: bool = False  # whether jump and relaxation are computed
    samples: int = FINE

    @property
    def shortest(self) -> int:
        """Number of shortest waves in a side."""
        return self.lengths * self.waves

    @property
    def slope(self) -> float:
        """Return the rms of the full gradient."""
        elements = 2 * self.shortest
        rings = ring_amplitudes(HURST, elements, rolloff=self.lengths)
        return rms_slope_of(rings, elements) * HEIGHT * elements / SIDE

    def material(self) -> tuple[dict, float]:
        """Return the table [material], and E''(q_max v)/E*."""
        slow = SIDE / (2.0 * np.pi * self.shortest * SPEED)  # 1/(q_max v)
        if self.power == 1.0:
            return {"shear_modulus": MODULUS, "relaxation_time": self.x * slow}, self.x
        times = 10.0 ** np.linspace(-3.0, 3.0, 13)  # in units of ``slow``
        shares = times**-self.power * LOST / np.sum(times**-self.power)
        branches = [
            [float(g) * MODULUS, float(t) * slow] for g, t in zip(shares, times, strict=True)
        ]
        lost = float(np.sum(shares * times / (1.0 + times**2)))
        return {"shear_modulus": MODULUS, "branches": branches}, lost

    def run(self, body: str, lines: np.ndarray | None = None) -> xr.Dataset:
        """Return the dataset of this point on a body, on given lines or random surfaces."""
        pressure = self.load * 4.0 * MODULUS * self.slope
        width = SIDE if self.whole else SIDE / self.lengths  # width of a line
        grid = {"normal_force": pressure * SIDE * (SIDE if body == HALF_SPACE else width)}
        grid |= {"velocity": SPEED, "velocity_step": STEP if self.step else 0.0}
        tables = {
            "study": {"title": "rough rows", "seed": SEED, "realizations": self.maps},
            "material": self.material()[0],
            "scene": {"body": body, "quantities": ["steady"]},
            "grid": grid,
        }
        if self.step:
            tables["scene"]["quantities"] += ["jump", "relaxation"]
        if lines is not None:
            tables["study"]["realizations"] = len(lines)
            given = profile_of_array(lines, SIDE)
            return compute(read_grid_study("rough", Path(), tables, True, given)).squeeze()
        if body == FOUNDATION:
            tables["study"]["realizations"] = max(200, 1600 // self.lengths)
        tables["surface"] = {"length": SIDE, "rolloff": SIDE / self.lengths}
        grid |= {"hurst": HURST, "roughness": HEIGHT, "spacing": SIDE / (2 * self.shortest)}
        fine: int | str = self.samples if body == HALF_SPACE else "auto"
        tables["numerics"] = {"steps_per_spacing": fine}
        return compute(read_grid_study("rough", Path(), tables)).squeeze()

    def equivalent(self) -> np.ndarray:
        """Return random lines with C_1D = pi q C_2D at all wave numbers, in m."""
        elements, step = 2 * self.shortest, 2.0 * np.pi / SIDE
        flat, last = step * self.lengths, step * (self.shortest + 0.5)

        def isotropic(q: np.ndarray) -> np.ndarray:
            return np.where(q < last, np.maximum(q, flat) ** (-2.0 * HURST - 2.0), 0.0)

        amplitude = equivalent_amplitudes(isotropic, SIDE, elements)
        amplitude *= HEIGHT / np.sqrt(0.5 * np.sum(amplitude**2))
        phases = np.random.default_rng(SEED).uniform(0.0, 2.0 * np.pi, (400, amplitude.size))
        n = elements * FINE
        modes = np.zeros((len(phases), n // 2 + 1), complex)
        modes[:, 1 : amplitude.size + 1] = 0.5 * n * amplitude * np.exp(1j * phases)
        return np.fft.irfft(modes, n, axis=1)


ROWS = {
    "area": [
        Rough(load, 4, power, 32, whole=True)
        for load in (0.003, 0.01, 0.03, 0.1, 0.3)
        for power in (1.0, 0.3, 0.0)
    ],
    "force": [
        Rough(0.05, lengths, 0.3, maps, whole=True, samples=m)
        for lengths, maps, m in ((1, 128, 8), (4, 16, 8), (16, 4, 4))
    ],
    "pressure": [
        Rough(load, lengths, power, maps, samples=m)
        for load in (0.01, 0.1)
        for power in (0.3, 1.0)
        for lengths, maps, m in ((1, 128, 8), (2, 64, 8), (4, 16, 8), (16, 4, 4))
    ],
    "speed": [Rough(0.1, 1, 1.0, 16, x, waves=16) for x in (0.1, 1.0, 10.0, 30.0, 100.0)],
    "step": [Rough(0.05, 1, 1.0, 24, x, waves=16, step=True) for x in (3.0, 10.0)],
}


def normalised_friction(row: Rough, data: xr.Dataset) -> tuple[float, float]:
    """Return normalised friction with its standard error."""
    scale = row.slope * (row.material()[1] if row.x == SLOW else 1.0)
    return float(data.mu_1) / scale, float(data.mu_1_error) / scale


def kinetics(data: xr.Dataset) -> list[tuple[float, float]]:
    """Return b per tau and the jump over mu_1, with their standard errors."""
    rate, jump = (
        (float(data[name] * scale), float(data[f"{name}_error"] * scale))
        for name, scale in (("relaxation_rate", data.tau), ("jump", 1.0 / data.mu_1))
    )
    return [rate, jump]


def table_line(name: str, row: Rough) -> str:
    """Return one line of the table, in Markdown."""
    half = row.run(HALF_SPACE)
    datasets = [half, row.run(FOUNDATION), row.run(FOUNDATION, row.equivalent())]
    frictions = [normalised_friction(row, data) for data in datasets]
    mu_half, error_half = frictions[0]
    pairs = [(float(half.contact_fraction), float(half.contact_fraction_error)), *frictions]
    for mu, error in frictions[1:]:
        ratio = mu / mu_half
        pairs.append((ratio, ratio * np.hypot(error / mu, error_half / mu_half)))
    if row.step:
        pairs += kinetics(half) + kinetics(datasets[1])
    cells = [name, *(f"{value:g}" for value in (row.load, row.lengths, row.power, row.x))]
    cells += [f"{value:.4f} ± {error:.4f}" for value, error in pairs]
    return f"| {' | '.join(cells)} |"


def _main() -> None:
    """Print the table, or only the named rows."""
    head = (
        "row | load | lengths | s | x | area | half-space | foundation | equivalent line | ratios"
    )
    print(f"| {head} of both | b and jump/mu of both bodies |")
    for name in sys.argv[1:] or ROWS:
        for row in ROWS[name]:
            print(table_line(name, row), flush=True)


if __name__ == "__main__":
    _main()
