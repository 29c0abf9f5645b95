"""The heat of friction in studies: similarity, tasks, comparisons, and its sum with the shear."""

import numpy as np
import pytest

from tests.support.small import keys, small_plan
from tests.workflow.scene.scenes import run_on_half_space

WLF = {"c1": 8.86, "c2": 101.6, "reference": 20.0}
MATERIAL = {"shear_modulus": 1e6, "branches": [[5e6, 1e-5]], "wlf": WLF, "temperature": 20.0}
SURFACE = {"length": 1e-3, "hurst": 0.8, "roughness": 2e-5, "spacing": 1.25e-4}
HEAT = {"conductivity": 0.2, "heat_capacity": 2e6}
MOTION = (
    {"slide": {"velocity": 1.0, "distance": 2.5e-4}},
    {"slide": {"velocity": 3.0, "distance": 5e-4}},
)


def run(*programme, **changed):
    scene = {"surface": SURFACE, "material": MATERIAL, "normal_pressure": 3e5, "realizations": 2}
    scene["quantities"] = ["steady", "trace"]
    return run_on_half_space(programme or MOTION, **(scene | changed))


def test_friction_of_similar_scenes_in_si_units_is_equal():
    """Lengths times 2, times times 4: speeds by 1/2, a diffusivity by 1, pressures by 4."""
    one = run(heat=HEAT | {"block": 2e-3})
    surface = SURFACE | {name: 2.0 * SURFACE[name] for name in ("length", "roughness", "spacing")}
    material = MATERIAL | {"shear_modulus": 4e6, "branches": [[2e7, 4e-5]]}
    motion = [
        {"slide": {"velocity": 0.5 * v, "distance": 2.0 * d}} for v, d in ((1, 2.5e-4), (3, 5e-4))
    ]
    # Power per area times length over conductivity: 4 * 1/2 * 2 = 4.
    heat = {"conductivity": 0.8, "heat_capacity": 8e6, "block": 4e-3}
    other = run(*motion, surface=surface, material=material, normal_pressure=1.2e6, heat=heat)
    for name in ("mu_1", "mu_2", "contact_temperature", "trace_mu", "trace_flash_temperature"):
        np.testing.assert_allclose(other[name], one[name], rtol=1e-9)
    assert one.contact_temperature > 21.0


def test_heat_lowers_friction_and_shear_heats_too():
    cold, hot, both = run(), run(heat=HEAT), run(heat=HEAT, shear={"stress": 3e6})
    assert hot.mu_1 < cold.mu_1
    assert both.mu_1_viscoelastic < hot.mu_1
    assert 20.0 < hot.contact_temperature < both.contact_temperature < both.flash_temperature
    stress = 3e6 * both.contact_fraction / 3e5
    np.testing.assert_allclose(both.mu_1_shear, stress, rtol=1e-9)  # a constant stress
    total = both.trace_mu_viscoelastic + both.trace_mu_shear
    np.testing.assert_allclose(both.trace_mu, total, rtol=1e-12)
    np.testing.assert_allclose(both.trace_mu_shear[0], both.mu_1_shear, rtol=1e-6)
    assert np.all(both.trace_contact_temperature <= both.trace_flash_temperature + 1.0)


def test_points_of_equal_force_over_roughness_share_no_task_with_heat():
    settings = (
        'scene.body="half-space"',
        'scene.quantities=["steady"]',
        "grid.normal_force=[1.0, 2.0]",
        "grid.roughness=[1e-6, 2e-6]",
        "material.wlf={c1=8.86, c2=101.6, reference=20}",
        "material.temperature=20",
    )
    warm = "scene.heat={conductivity=0.2, heat_capacity=2e6}"
    cold, hot = (keys(small_plan(*settings, *more)) for more in ((), (warm,)))
    assert len(hot) * 3 == len(cold) * 4


def test_a_temperature_beyond_the_table_ends_the_run_in_one_line():
    material = {name: MATERIAL[name] for name in ("shear_modulus", "branches", "temperature")}
    material["shifts"] = [[0, 1], [21, 0]]
    with pytest.raises(Exception, match=r"v = 1 m/s the contact reaches [\d.]+ °C"):
        run(material=material, heat=HEAT, quantities=["steady"])
