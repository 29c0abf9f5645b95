"""Block means with a known answer: exact exponentials whose amplitude varies between blocks."""

import numpy as np

from elastomer_friction.workflow.plan.problems import speed_ratio
from elastomer_friction.workflow.reduce.blocks import Blocks
from elastomer_friction.workflow.reduce.complete import exponents_of
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.reduce.resolution import resolution
from elastomer_friction.workflow.result.dataset import build_dataset
from elastomer_friction.workflow.study.effects.quantities import accuracy_estimates
from tests.support.small import small_plan

QUANTITIES = ("steady", "jump", "relaxation", "models")
RATE, JUMP, STEP = 1.5, 0.3, 0.2  # b, dmu_0, mu_2 - mu_1


def exponential_blocks(tasks=3, blocks=5, samples=33, quantities=QUANTITIES, seed=1):
    """Return blocks of tasks with b = RATE (1 + task); the curve of the last task ends early."""
    rng = np.random.default_rng(seed)
    rate = RATE * (1.0 + np.arange(tasks))
    time = np.linspace(0.05, 4.0, samples) / rate[:, None]
    mu_1 = 1.0 + 0.1 * rng.standard_normal((tasks, blocks))
    share = 1.0 + 0.1 * rng.standard_normal((tasks, blocks))
    mu_2 = mu_1 + STEP
    rates = rate[:, None] * (1.0 + 1e-8 * rng.standard_normal((tasks, blocks)))  # a small spread
    decay = np.exp(-rates[..., None] * time[:, None, :])
    curves = mu_2[..., None] + share[..., None] * (JUMP - STEP) * decay
    contact = rng.random((tasks, blocks))
    indentation = rng.standard_normal((tasks, blocks))
    samples_per_contact = 10.0 + rng.random((tasks, blocks))
    means = [mu_1, indentation, contact, samples_per_contact, mu_2, JUMP * np.ones_like(mu_1)]
    scalars = np.stack(means, axis=2)
    time[-1, -4:] = np.nan
    curves[-1, :, -4:] = np.nan
    return Blocks(scalars, {"curve": curves}, time, np.ones(tasks), quantities)


GRID = (
    "grid.roughness=[1e-5, 3e-5]",
    "grid.spacing=[1e-4, 2e-4]",
    "grid.normal_force=[0.04, 0.4, 1.2]",
    "grid.velocity=[0.02, 0.2, 0.5]",
)


def assembled(*settings):
    """Return the plan of the small study, synthetic estimates, and the dataset from both."""
    plan = small_plan(*GRID, *settings)
    variant = plan.variants[0]
    samples = variant.numerics.curve_samples - 1
    blocks = exponential_blocks(len(variant.tasks), 4, samples, plan.study.scene.quantities)
    estimates = reduce_blocks(blocks)
    estimates["rms_slope"] = np.arange(1.0, len(variant.tasks) + 1)
    estimates["realizations"] = np.full(len(variant.tasks), 4, np.int32)
    estimates["speed_ratio"] = np.array([speed_ratio(t.problem) for t in variant.tasks])
    steps = [task.steps_per_spacing for task in variant.tasks]
    estimates["steps_per_spacing"] = np.array(steps, np.int32)
    names = accuracy_estimates(plan.study.scene.quantities)
    estimates |= resolution(variant.tasks, estimates, names, variant.numerics)
    exponents = exponents_of(plan, variant, estimates)
    return plan, estimates, build_dataset(plan, variant, estimates, exponents)
