"""A layer on a rigid base: elasticity, limits, a smooth sphere and rough surfaces."""

import numpy as np
import pytest

from elastomer_friction.kernels import KELVIN, Case, Effects, Layer, Quantities, Spectrum
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.persson import persson_theory, waves_of_map
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.interface.layer import BACKINGS, compliance_ratio
from tests.kernels.half_space.test_known_answers_of_bodies import sphere

STEADY = Quantities(jump=False, relaxation=False)
BRANCHES = Spectrum((2.0, 5.0), (0.3, 0.08), 0.0)


def elastic_compliance(s: float, backing: str, poisson: float) -> float:
    """Return q/2 E* times the deflection of a strip of depth s/q under a wave of unit pressure.

    Plane strain, Airy's function (A + B y) cosh y + (C + D y) sinh y, y from the base in 1/q.
    Stresses and displacements over cos x or sin x; 2 G u_y from its derivatives.
    """
    cosh, sinh = np.cosh(s), np.sinh(s)
    # Columns A, B, C, D of the function f and of its first three derivatives, at y.
    at = {
        0.0: np.array([[1, 0, 0, 0], [0, 1, 1, 0], [1, 0, 0, 2], [0, 3, 1, 0]], float),
        s: np.array(
            [
                [cosh, s * cosh, sinh, s * sinh],
                [sinh, cosh + s * sinh, cosh, sinh + s * cosh],
                [cosh, 2 * sinh + s * cosh, sinh, 2 * cosh + s * sinh],
                [sinh, 3 * cosh + s * sinh, cosh, 3 * sinh + s * cosh],
            ]
        ),
    }

    def fields(y):
        f, f1, f2, f3 = at[y]
        along = (1.0 - poisson) * f2 + poisson * f  # 2 G du_x/dx over cos x
        normal = (1.0 - poisson) * f3 - (2.0 - poisson) * f1  # 2 G u_y over cos x
        return f, f1, along, normal

    top, base = fields(s), fields(0.0)
    # Stress: normal -f, shear f'. The base does not move along y; along x, or its shear vanishes.
    rows = [top[0], top[1], base[3], base[2] if backing == "bonded" else base[1]]
    coefficients = np.linalg.solve(np.array(rows), [1.0, 0.0, 0.0, 0.0])
    return abs(top[3] @ coefficients) / (2.0 * (1.0 - poisson))


@pytest.mark.parametrize("backing", BACKINGS)
@pytest.mark.parametrize("poisson", [0.5, 0.49, 0.3, 0.0])
def test_the_ratio_is_that_of_an_elastic_strip(backing, poisson):
    depths = np.array([0.1, 0.5, 1.0, 2.0, 4.0])
    expected = [elastic_compliance(s, backing, poisson) for s in depths]
    result = compliance_ratio(Layer(2.0, backing, poisson), 0.5 * depths)
    np.testing.assert_allclose(result, expected, rtol=1e-9)


@pytest.mark.parametrize("poisson", [0.5, 0.3])
def test_thick_and_thin_layers(poisson):
    thin = np.array([1e-3, 5e-3])
    bonded, free = (Layer(1.0, backing, poisson) for backing in BACKINGS)
    expected = 2.0 / 3.0 * thin**3
    if poisson < 0.5:
        expected = thin * (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson) ** 2)
    np.testing.assert_allclose(compliance_ratio(bonded, thin), expected, rtol=2e-2)
    np.testing.assert_allclose(compliance_ratio(free, thin), 0.5 * thin, rtol=1e-4)
    for layer in (bonded, free):
        assert compliance_ratio(layer, np.array([0.0, 40.0, 1e4])).tolist() == [1.0, 1.0, 1.0]


@pytest.mark.parametrize("backing", BACKINGS)
@pytest.mark.parametrize("thickness", [4.0, 1.0, 0.25])
def test_slow_friction_of_a_sphere_does_not_depend_on_the_thickness(backing, thickness):
    """The friction coefficient is v tau/R for a Kelvin element, over the radius of contact.

    Brilliantov and Poeschel, Europhys. Lett. 42, 511 (1998), doi:10.1209/epl/i1998-00281-7, for a
    deep body. It holds for any layer: the viscous pressure is v tau dp/dx for the elastic p, since
    a stiffness that is the same everywhere commutes with the derivative, and its moment with the
    slope x/R is the load times v tau/R.
    """
    n, side, radius = 128, 6.0, 60.0  # in radii of contact of a half-space
    surface, dx = sphere(n, side, radius), side / n
    load, speed = 4.0 / (3.0 * radius) / side, 0.01
    effects = Effects(layer=Layer(thickness / dx, backing, 0.5))
    case = Case(load, speed / dx, (), (), "exponential", KELVIN, effects=effects)
    assert run_case(surface, case, STEADY).mu_1 / dx == pytest.approx(speed / radius, rel=0.03)


@pytest.mark.parametrize("backing", BACKINGS)
def test_persson_theory_of_a_layer_is_exact_in_full_contact(backing):
    n, load, speed, layer = 8, 3e3, 0.3, Layer(0.7, backing, 0.5)
    amplitude = ring_amplitudes(0.7, n, cutoff=2)
    surface = Surface.drawn(np.random.default_rng(1), amplitude, n, 16)
    case = Case(load, speed, (), (), "exponential", BRANCHES, effects=Effects(layer=layer))
    result = run_case(surface, case, STEADY)
    mu, area = persson_theory(waves_of_map(amplitude, n), BRANCHES, load / n, speed, layer)
    assert result.contact_fraction == 1.0
    assert area == pytest.approx(1.0, abs=1e-12)
    assert mu == pytest.approx(result.mu_1, rel=0.01)


def test_friction_and_area_over_the_thickness():
    """Values of a plain prototype on one map, over the thickness in longest waves, at x = 1.

    Its map is not recorded. Here one has four longest waves a side, and the shortest is a quarter.
    """
    thicknesses = [2.0, 1.0, 0.5, 0.25, 0.125, 0.0625]
    friction = [1.00, 1.00, 0.98, 0.93, 0.89, 0.94]
    area = [1.00, 0.99, 0.96, 0.84, 0.57, 0.28]
    n, waves, shortest = 32, 4.0, 16
    amplitude = ring_amplitudes(0.7, n, rolloff=waves, cutoff=shortest)
    load = 0.1 * rms_slope_of(amplitude, n) * n
    surface = Surface.drawn(np.random.default_rng(1), amplitude, n, 4)
    case = Case(load, n / (2.0 * np.pi * shortest), (), (), "exponential", KELVIN)
    deep, *layers = (
        run_case(surface, case._replace(effects=Effects(layer=layer)), STEADY)
        for layer in (None, *(Layer(d * n / waves, "bonded", 0.5) for d in thicknesses))
    )
    for one, mu, touching in zip(layers, friction, area, strict=True):
        assert one.mu_1 / deep.mu_1 == pytest.approx(mu, abs=0.06)
        ratio = one.contact_fraction / deep.contact_fraction
        assert ratio == pytest.approx(touching, abs=0.06)
