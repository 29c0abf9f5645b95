"""Error of the model: both bodies at the points of a study, or an order of magnitude."""

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.workflow.plan import MODEL_LABEL
from tests.support.small import TEXT, small_plan

# Reference: half-spaces by elastic contacts alone, with weak loss, and foundations: 0.724(11).
WEAK = {
    "surface": {
        "length": 1e-3,
        "rolloff": 5e-4,
        "hurst": 0.188,
        "spacing": 31.25e-6,
        "roughness": 5e-6,
    },
    "material": {
        "shear_modulus": 1e6,
        "branches": [[2e4, time] for time in (1e-5, 1e-4, 1e-3, 1e-2, 1e-1)],
    },
    "normal_pressure": 44.5e3,
    "programme": [{"slide": {"velocity": 0.098, "distance": 31.25e-6}}],
    "realizations": 16,
    "seed": 1,
}
REFERENCE = 0.724, 0.011


@pytest.mark.parametrize("body", ["foundation", "half-space"])
def test_ratio_of_weak_loss_is_that_of_elastic_contacts(body):
    data = ef.scene.run(body=body, quantities=["steady", "model_ratio"], **WEAK).squeeze()
    ratio, error = float(data.model_ratio), float(data.model_ratio_error)
    assert abs(ratio - REFERENCE[0]) < 3.0 * np.hypot(error, REFERENCE[1])
    assert 0.0 < error < 0.08
    assert data.attrs["model_ratio_source"] == "measured on both bodies"
    assert data.model_realizations > 1


def test_half_space_is_compared_by_default_and_a_foundation_only_if_it_is_cheap():
    pressed = TEXT.replace("normal_force = [0.04, 0.4]", "normal_pressure = [2e4, 4e4]")
    settings = ('scene.quantities=["steady"]', "grid.spacing=1e-3")
    on_map = small_plan(*settings, text=pressed)
    assert on_map.other_body is not None
    assert on_map.other_body.label == MODEL_LABEL
    assert on_map.other_body.lines.body == "foundation"
    on_line = small_plan(*settings, "scene.body=foundation", text=pressed)
    assert on_line.other_body is None
    assert 'the quantity "model_ratio" measures it in' in on_line.no_other_body
    requested = ('scene.quantities=["steady", "model_ratio"]', *settings[1:])
    assert small_plan(*requested, "scene.body=foundation", text=pressed).other_body is not None


def test_comparison_with_the_other_body_is_the_other_body():
    text = TEXT.partition("[compare")[0] + '[compare.block]\nbody = "half-space"\n'
    plan = small_plan('scene.quantities=["steady"]', "grid.spacing=1e-3", text=text)
    assert plan.other_body is plan.variants[1]


def test_loads_of_both_bodies_are_those_of_one_pressure():
    pressed = TEXT.replace("normal_force = [0.04, 0.4]", "normal_pressure = [2e4, 4e4]")
    settings = ('scene.quantities=["steady"]', "grid.spacing=1e-3", "surface.rolloff=5e-3")
    plan = small_plan(*settings, text=pressed)
    compared = pressed.partition("[compare")[0] + '[compare.line]\nbody = "foundation"\n'
    other = small_plan(*settings, text=compared)
    ours, theirs = (
        [task.problem[:5] for task in part.tasks] for part in (plan.other_body, other.variants[1])
    )
    np.testing.assert_allclose(ours, theirs, rtol=1e-9)


def test_spectrum_that_no_map_holds_has_an_order_of_magnitude():
    data = ef.scene.run(
        **{**WEAK, "surface": WEAK["surface"] | {"spacing": 1e-3 / 2048}},
        body="foundation",
        quantities=["steady"],
    ).squeeze()
    assert "Persson's theory" in data.attrs["model_ratio_source"]
    assert "2048 x 2048" in data.attrs["model_ratio_source"]
    assert 0.05 < float(data.model_ratio) < 5.0
    assert float(data.model_ratio_error) == pytest.approx(0.6 * float(data.model_ratio), rel=0.05)


def test_rows_of_a_measured_map_are_compared_with_the_map():
    rng = np.random.default_rng(3)
    heights = 1e-6 * np.real(np.fft.ifft2(np.fft.fft2(rng.standard_normal((16, 16)))))
    scene = {name: WEAK[name] for name in ("material", "normal_pressure", "programme")}
    data = ef.scene.run(profile=heights, length=1e-3, quantities=["steady"], **scene).squeeze()
    rows = ef.scene.run(
        profile=heights,
        length=1e-3,
        quantities=["steady"],
        body="foundation",
        realizations=16,
        **scene,
    ).squeeze()
    assert data.attrs["body"] == "half-space"
    assert data.model_realizations == 16
    assert float(data.model_ratio * data.mu_1) == pytest.approx(float(rows.mu_1), rel=1e-6)
