"""The quantity persson: beside mu_1 in a result, and the same in full contact."""

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.workflow.reduce import reduce_blocks
from elastomer_friction.workflow.reduce.blocks import blocks_of, reduction_of
from elastomer_friction.workflow.reduce.complete import completed
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.support.small import cut_batches, small_plan

FULL = (
    'scene.quantities=["steady", "persson"]',
    "scene.body=half-space",
    "grid.spacing=2.5e-3",  # 4 elements a side
    "grid.normal_force=1e7",
    "grid.hurst=0.7",
    "numerics.steps_per_spacing=16",
    "study.realizations=2",
)


def test_both_bodies_have_the_theory_of_the_same_surface():
    """In full contact the theory is exact for the half-space, and independent of the body."""
    scene = {
        "surface": {"length": 1e-3, "rolloff": 5e-4, "hurst": 0.7, "roughness": 1e-6},
        "material": {"shear_modulus": 1e6, "relaxation_time": 1e-4},
        "normal_pressure": 1e7,
        "programme": [{"slide": {"velocity": 0.1, "distance": 1e-4}}],
        "quantities": ["steady", "persson"],
        "realizations": 4,
    }
    scene["surface"]["spacing"] = 1.25e-4
    on_map, on_line = (ef.scene.run(body=body, **scene) for body in ("half-space", "foundation"))
    assert float(on_map.contact_fraction) == 1.0
    assert float(on_map.mu_persson) == pytest.approx(float(on_map.mu_1), rel=0.02)
    assert float(on_line.mu_persson) == float(on_map.mu_persson)


def test_in_full_contact_it_is_mu_1():
    plan = small_plan(*FULL)
    variant = plan.variants[0]
    batch = next(b for b in cut_batches(plan, set(), 1e9) if b.tasks[0] in variant.tasks)
    actual = block_means(batch)
    tasks, how = list(batch.tasks), reduction_of(variant)
    estimates = reduce_blocks(blocks_of(how, tasks, actual.scalars, actual.curves))
    rows, counts = np.arange(len(variant.tasks)), np.full(len(variant.tasks), 2, np.int32)
    whole = completed(plan, variant, estimates, rows, counts)
    assert whole["contact_fraction"] == pytest.approx(np.ones(rows.size))
    assert whole["area_persson"] == pytest.approx(np.ones(rows.size))
    assert whole["mu_persson"] == pytest.approx(whole["mu_1"], rel=0.02)
