"""Friction of a rigid sphere over its speed on both bodies and on layers, with reference values.

At rest on the relaxed body the contact radius is a = (3 F_N R/(4 E*))^(1/3). For v -> 0 a Kelvin
half-space has F_x = (4/3) E* tau v a^3/R^2, so that mu = v tau/R, and so have layers of any
thickness. Source: N. V. Brilliantov, T. Poeschel, Europhys. Lett. 42, 511 (1998),
doi:10.1209/epl/i1998-00281-7. A constant shear stress tau_f of the contact adds tau_f A/F_N, where
A = pi a^2 for v -> 0. The unit of length is the side of the cell, and E* = 1.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import xarray as xr

from elastomer_friction.kernels import (
    BACKINGS,
    KELVIN,
    Case,
    Effects,
    Layer,
    Line,
    Quantities,
    Spectrum,
    run_case,
)
from elastomer_friction.kernels.half_space.cases import run_case as run_on_half_space
from elastomer_friction.kernels.half_space.surface import Surface
from elastomer_friction.workflow.study import Key, integer, positive

STEADY = Quantities(jump=False, relaxation=False)
MIN_CELL, MAX_CELL, CELL_PER_SPEED = 6.0, 24.0, 8.0  # side in contact radii at rest: see cell_at
SAMPLES_PER_RADIUS = 10.0  # smallest number per contact radius in cells larger than MIN_CELL
SECONDS_PER_SAMPLE = 2e-5  # per sample of the map and speed
MIN_SPEED, MAX_SPEED = 0.003, 10.0  # v tau/a
# Rows: v 10 ms/a, mu, and the side of the cell in contact radii at which the computed mu converges.
# Digitised from Carbone and Putignano, J. Mech. Phys. Solids 61, 1822 (2013), fig. 12: R = 1 cm,
# F_N = 0.15 N, nu = 0.3, relaxed modulus E = 1 MPa, one branch of 9 MPa and 1 ms.
PUBLISHED = ((0.106, 0.00851, 9.0), (1.169, 0.0403, 12.0), (7.943, 0.0159, 36.0))
SLS = Spectrum((9.0,), (1.0 / 9.0,), 0.0)  # tau = sum g t/G = 9 ms
RADIUS, FORCE, MODULUS, TIME = 0.01, 0.15, 1e6 / (1.0 - 0.3**2), 9e-3
SETTINGS = {  # documented in docs/reference/measures.md
    "side": Key(partial(integer, least=16)),
    "speeds": Key(partial(integer, least=2)),
    "thickness": Key(positive),
    "shear_stress": Key(positive),
    "published": Key(partial(integer, least=0)),
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return a description of the measurement, and the predicted seconds of one core."""
    count = (1 + len(BACKINGS)) * settings["speeds"] + 3 * settings["published"]
    side = settings["side"]
    lines = [f"cell        {side} x {side} samples, {MIN_CELL:g} to {MAX_CELL:g} radii a side"]
    return lines, SECONDS_PER_SAMPLE * count * side**2


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return friction over the speed, and the published points with computed values."""
    speeds = np.geomspace(MIN_SPEED, MAX_SPEED, settings["speeds"])
    side, seconds = settings["side"], SECONDS_PER_SAMPLE * settings["side"] ** 2
    layers = [Layer(settings["thickness"], backing, poisson=0.5) for backing in BACKINGS]
    frictions, areas, on_layers = [], [], []
    for speed in speeds:
        cell = cell_at(speed, side)
        ratio = _radius(cell) / _radius(MIN_CELL)
        *both, area = _both(side, speed, KELVIN, cell)
        frictions.append([mu * ratio for mu in both])
        areas.append(area)
        on_layers.append([_on_map(side, speed, KELVIN, cell, layer)[0] * ratio for layer in layers])
        advance((1 + len(layers)) * seconds)
    known = dict(zip(BACKINGS, np.transpose(on_layers), strict=True))
    radius = _radius(MIN_CELL)
    known["closed"] = speeds / radius  # v tau/R from v tau/a
    known["shear"] = settings["shear_stress"] * np.array(areas) / (4.0 / 3.0 / radius)
    groups = {"": _over_speed(speeds, frictions, known, "v tau over the radius of contact at rest")}
    if settings["published"]:
        groups["published"] = _published(settings["side"])
        advance(len(PUBLISHED) * seconds)
    return groups


def cell_at(speed: float, side: int) -> float:
    """Return the side L of the cell in contact radii, long enough for small exp(-L/(v tau)).

    speed : v tau/a. side : in samples.
    """
    return max(MIN_CELL, min(MAX_CELL, CELL_PER_SPEED * speed, side / SAMPLES_PER_RADIUS))


def _radius(cell: float) -> float:
    """Return the radius of the sphere in contact radii, large enough for small slopes."""
    return 10.0 * cell


def _both(side: int, speed: float, spectrum: Spectrum, cell: float) -> tuple[float, float, float]:
    """Return mu of half-space and foundation, and the real contact area of the half-space in a^2.

    speed : v tau/a. cell : side in contact radii a.
    """
    heights = _places(side, cell) ** 2 / _radius(cell)
    line = Line.from_samples(heights, np.gradient(heights), 1)
    foundation = run_case(line, _case(side, speed, spectrum, cell), STEADY).mu_1
    half_space, area = _on_map(side, speed, spectrum, cell)
    return half_space, foundation * side / cell, area


def _on_map(
    side: int, speed: float, spectrum: Spectrum, cell: float, layer: Layer | None = None
) -> tuple[float, float]:
    """Return mu and area of a half-space, or of a layer with a thickness in a; cf. ``_both``."""
    x, case = _places(side, cell), _case(side, speed, spectrum, cell)
    heights = (x[:, None] ** 2 + x**2) / (2.0 * _radius(cell))
    # Slopes of a paraboloid in heights per element, one-sided at the seam.
    surface = Surface.from_samples(heights, np.gradient(heights, axis=-1), 1)
    if layer is not None:
        scaled = layer._replace(thickness=layer.thickness * side / cell)
        case = case._replace(effects=Effects(layer=scaled))
    sliding = run_on_half_space(surface, case, STEADY)
    return sliding.mu_1 * side / cell, sliding.contact_fraction * cell**2


def _places(side: int, cell: float) -> np.ndarray:
    """Return the places of the samples of a side of the cell from its centre, in contact radii."""
    return cell * ((np.arange(side) + 0.5) / side - 0.5)


def _case(side: int, speed: float, spectrum: Spectrum, cell: float) -> Case:
    """Return the case of a sphere, with Fbar = F_N/(E* L h), F_N = (4/3) E* a^3/R and h = a."""
    load = 4.0 / (3.0 * _radius(cell)) / cell
    return Case(load, speed * side / cell, (), (), "exponential", spectrum, refine=False)


def _published(side: int) -> xr.Dataset:
    rest = (0.75 * FORCE * RADIUS / MODULUS) ** (1.0 / 3.0)
    speeds = [speed for speed, _, _ in PUBLISHED]
    frictions = []
    for speed, _, cell in PUBLISHED:
        # Slopes scale with a/R, which differs from that of the computation.
        *ours, _ = _both(side, speed * TIME / 0.01, SLS, cell)
        frictions.append([mu * _radius(cell) * rest / RADIUS for mu in ours])
    known = {"published": np.array([mu for _, mu, _ in PUBLISHED])}
    return _over_speed(np.array(speeds), frictions, known, "v 10 ms over the radius of contact")


def _over_speed(
    speeds: np.ndarray, frictions: list[list[float]], reference: dict[str, np.ndarray], text: str
) -> xr.Dataset:
    """Return mu of both bodies and the reference over the speed. text : meaning of the speed."""
    columns = (
        dict(zip(("half_space", "foundation"), np.array(frictions).T, strict=True)) | reference
    )
    data = {name: ("speed", values) for name, values in columns.items()}
    return xr.Dataset(data, {"speed": ("speed", speeds, {"long_name": text})})
