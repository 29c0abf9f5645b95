"""Standard errors of a single map by its tiles: sums, jackknife, and maps that have none."""

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.kernels import KELVIN, form_of
from elastomer_friction.kernels.half_space.body import HalfSpace
from elastomer_friction.kernels.half_space.instant import friction_jumps
from elastomer_friction.kernels.half_space.sliding_body import slide_steadily
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.half_space.tiles import TILE_SUMS, quadratic_density, tile_sums
from elastomer_friction.workflow.reduce.blocks import Blocks, _folded
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.simulate import SCALARS

TILES = 4


@pytest.fixture(scope="module")
def sliding():
    surface = Surface.drawn(np.random.default_rng(2), ring_amplitudes(0.7, 8, 2.0), 8, 4)
    space = HalfSpace.under(form_of(KELVIN, "exponential"), surface, 0.3)
    return space, slide_steadily(space, KELVIN, 0.2)


def test_the_dissipated_power_of_all_tiles_is_friction(sliding):
    space, one = sliding
    power = quadratic_density(one.body.p, space.operator.compliance * one.loss)
    dissipative = (one.mu - one.viscous * one.step_mu) / (1.0 - one.viscous)
    assert tile_sums(power, TILES).sum() == pytest.approx(dissipative * one.body.p.sum())


def test_the_sums_of_tiles_are_proportional_to_the_jumps(sliding):
    space, one = sliding
    jumps, _, _, sums = friction_jumps(space, KELVIN, one, 0.2, (1.1, 2.0), TILES)
    shares = sums.sum(axis=(1, 2)) / jumps / np.array([0.1, 1.0])
    assert shares[0] == pytest.approx(shares[1], rel=0.1)  # contacts hardly change


def single_maps() -> dict[str, np.ndarray]:
    """Return the estimates of 400 maps, whose 5 x 5 tiles scatter independently about mu = 0.5."""
    generator = np.random.default_rng(3)
    load = generator.uniform(0.5, 1.5, (400, 5, 5))
    power = load * (0.5 + 0.1 * generator.standard_normal(load.shape))
    sums = {"load": load, "touching": 9.0 * load, "load_2": load}
    values = np.stack([sums.get(name, power) for name in TILE_SUMS], axis=1)[:, None]
    scalars = np.ones((len(load), 1, len(SCALARS)))
    scalars[:, 0, SCALARS.index("mu_1")] = power.sum(axis=(1, 2)) / load.sum(axis=(1, 2))
    none = np.empty((len(load), 0))
    return reduce_blocks(Blocks(scalars, {"tiles": values}, none, none, ("steady",)))


def test_the_error_is_the_scatter_of_maps_of_independent_tiles():
    estimates = single_maps()
    stated = np.sqrt(np.mean(estimates["mu_1_error"] ** 2))
    assert stated == pytest.approx(estimates["mu_1"].std(), rel=0.15)
    assert (estimates["degrees_of_freedom"] == 24).all()
    assert np.isnan(estimates["indentation_error"]).all()


def test_mirrored_tiles_are_counted_once():
    quarter = np.arange(9.0).reshape(3, 3)
    whole = np.block([[quarter, quarter[:, ::-1]], [quarter[::-1], quarter[::-1, ::-1]]])
    assert np.array_equal(_folded(whole), 4.0 * quarter)


def test_a_rough_map_has_an_error_and_a_sphere_has_none():
    x = 1e-5 * (np.arange(32) - 16)
    sphere = -(x[:, None] ** 2 + x**2) / 2e-3
    amplitudes = ring_amplitudes(0.7, 32, 4.0)
    rough = 5e-6 * Surface.drawn(np.random.default_rng(1), amplitudes, 32, 1).z
    slide = {"slide": {"velocity": 0.1, "distance": 1e-5}}
    known = []
    for profile in (sphere, rough):
        result = ef.scene.run(
            profile=profile,
            length=3.2e-4,
            material={"shear_modulus": 1e6, "relaxation_time": 1e-4},
            normal_pressure=5e4,
            body="half-space",
            programme=[slide],
            quantities=["steady"],
            numerics={"steps_per_spacing": 1},
        )
        known.append(bool(np.isfinite(result.mu_1_error)))
        assert "jackknife over 3 x 3 tiles" in result.attrs["standard_errors"]
    assert known == [False, True]
    assert 0.01 < float(result.mu_1_error / result.mu_1) < 0.5
    assert np.isfinite(result.mean_contact_pressure_error)
