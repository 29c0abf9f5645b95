"""The studies of the half-space: a sphere, both bodies, figure 7, and a tread rubber."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.studies.bodies.figure import ratios
from elastomer_friction.studies.rate_state_contact.figure import critical_distance, steady_change
from elastomer_friction.studies.sphere.measure import measure
from elastomer_friction.workflow.reduce.fits import FITTED
from tests.support.studies import check_drawing, run

pytestmark = pytest.mark.exhaustive


@pytest.fixture(
    scope="module",
    params=[
        "bodies",
        "fig7_half_space",
        "tread",
        "second_relaxation",
        "rate_state_contact",
        "tyre",
    ],
)
def study(request, tmp_path_factory):
    """Return name and groups of a study at smoke scale."""
    return request.param, run(tmp_path_factory.mktemp("half_space"), request.param)


def test_a_sphere_has_the_known_friction_on_a_half_space_and_the_foundation_twice_of_it():
    """Of first order in the samples while it is slow; published values at every speed."""
    coarse, fine = (
        measure(
            {"side": side, "speeds": 2, "thickness": 0.5, "shear_stress": 1e-4, "published": 1},
            0,
            lambda _: None,
        )
        for side in (64, 128)
    )
    slow, slower = (groups[""].isel(speed=0) for groups in (fine, coarse))
    extrapolated = 2.0 * slow.half_space - slower.half_space
    assert float(extrapolated) == pytest.approx(float(slow.closed), rel=2e-3)
    assert float(slow.foundation) == pytest.approx(2.0 * float(slow.closed), rel=0.01)
    # tau pi a^2/F_N with F_N = (4/3) E* a^3/R and R = 60 a.
    assert float(slow.shear) == pytest.approx(1e-4 * np.pi * 0.75 * 60.0, rel=0.02)
    published = fine["published"]
    assert published.half_space.values == pytest.approx(published.published.values, rel=0.06)
    check_drawing("sphere", fine)


def test_the_critical_distance_is_that_of_an_exponential_relaxation():
    """Interpolated between samples; NaN where the relaxation is within three errors of zero."""
    speeds, lengths = np.array([1e-3, 1.0, 1.0]), np.array([1e-4, 2e-4, 2e-4])  # m/s, m
    slid = np.linspace(0.0, 1e-3, 201)
    deviation = 0.1 * np.exp(-slid / lengths[:, None])
    errors = np.array([1e-3, 1e-3, 0.05])[:, None] * np.ones(slid.size)
    curves = {
        "deviation": deviation,
        "deviation_error": errors,
        "time_s": slid / (3.0 * speeds[:, None]),
    }
    points = xr.Dataset(
        {name: (("velocity", "sample"), values) for name, values in curves.items()},
        coords={"velocity": speeds, "velocity_step": 2.0},
    )
    distance = critical_distance(points)
    assert distance.value[:2] == pytest.approx(1e3 * lengths[:2], rel=1e-3)
    bound = 1e-3 / 0.1 * (1.0 + np.e)  # (error + error/e)/(slope of the deviation), over D_c
    assert distance.error[:2] == pytest.approx(1e3 * lengths[:2] * bound, rel=0.03)
    assert np.isnan(distance.value[2])


def test_the_study_shows_the_physics(study):
    name, groups = study
    {
        "bodies": _bodies,
        "fig7_half_space": _fig7_half_space,
        "tread": _tread,
        "second_relaxation": _second_relaxation,
        "rate_state_contact": _rate_state_contact,
        "tyre": _tyre,
    }[name](groups)


def _bodies(groups):
    """Alike where little touches, far too little on the foundation where much does."""
    for half in ("", "broad"):
        actual = ratios(groups, half)
        light, heavy = (actual.isel(normal_force=row).ratio for row in (0, -1))
        assert np.all((light > 0.6) & (light < 1.7))
        assert np.all(heavy < 0.3)
    whole = groups[""].squeeze()
    full = whole.contact_fraction.values > 0.99
    assert full.any()
    assert whole.mu_persson.values[full] == pytest.approx(whole.mu_1.values[full], rel=0.05)
    share = whole.area_persson / whole.contact_fraction
    # Where contacts hold few samples their area is that of coarse maps.
    assert np.all((share > 0.6) & (share < xr.where(whole.samples_per_contact > 20.0, 1.1, 1.7)))


def _fig7_half_space(groups):
    """b grows with x, and its exponent depends less on H than on the foundation."""
    whole, line = groups[""].squeeze(), groups["foundation"].squeeze()
    assert (whole.fit_status == FITTED).sum() >= 6
    early, late = (whole.relaxation_rate.isel(velocity=k) for k in (0, 2))
    assert np.all(late > early)
    spread = {
        name: float(np.ptp(data.alpha.values)) for name, data in (("", whole), ("line", line))
    }
    assert spread[""] < spread["line"]
    plateau = whole.jump / whole.rms_slope / 0.2
    assert np.all(plateau.isel(velocity=-1) < 0.3)  # the paper has 0.4


def _tyre(groups):
    """Friction rises with the speed where the rubber is warm, and less of it touches then."""
    whole = groups[""].squeeze()
    warm = whole.sel(temperature=60)
    assert np.all(np.diff(warm.mu_1) > 0.0)
    assert np.all(np.diff(warm.contact_fraction) < 0.0)
    cold = whole.sel(temperature=20)
    assert np.all(cold.contact_fraction < warm.contact_fraction)  # it is stiffer


def _tread(groups):
    """Shear exceeds the loss at low speeds, and heating softens the rubber at high ones."""
    hot, cold = (groups[name].squeeze() for name in ("", "cold"))
    slow, fast = (hot.isel(velocity=k) for k in (0, -1))
    assert np.all(slow.mu_1_shear > slow.mu_1_viscoelastic)
    assert np.all(fast.mu_1_viscoelastic < cold.isel(velocity=-1).mu_1_viscoelastic)
    assert np.all(fast.contact_fraction > cold.isel(velocity=-1).contact_fraction)
    assert np.all(np.diff(hot.contact_temperature, axis=hot.mu_1.dims.index("velocity")) > 0.0)


def _second_relaxation(groups):
    """The block warms on after the contact has relaxed, and friction falls with it."""
    heated, flash, cold = (groups[name].squeeze() for name in ("", "flash", "cold"))
    late = heated.trace_distance > 0.5 * heated.trace_distance[-1]
    assert np.all(np.diff(heated.trace_contact_temperature[late]) > -0.5)
    ends = [float(data.trace_mu[-1]) for data in (heated, flash, cold)]
    assert ends == sorted(ends)


def _rate_state_contact(groups):
    """The direct effect is that of the shear alone, and changes sign at the top of the bell."""
    data = groups[""].squeeze()
    slow, fast = (data.isel(velocity=k) for k in (0, -1))
    assert slow.jump > 0.0 > fast.jump
    assert data.jump.values == pytest.approx(data.jump_shear.values)
    change = steady_change(data)
    assert change.value * np.log(3.0) == pytest.approx((data.mu_2 - data.mu_1).values)
    assert change.value[0] > 3.0 * change.error[0]
    assert change.value[-1] < -3.0 * change.error[-1]
