"""March in blocks, against the march of all elements."""

import gc

import numpy as np
import pytest
from numba.core.runtime import rtsys
from numba.core.runtime._nrt_python import memsys_enable_stats

from elastomer_friction.kernels.body.shiftable_line import shiftable_line
from elastomer_friction.kernels.body.step import Move, accept, attempt, elements_of, law_in_step
from elastomer_friction.kernels.compile.jit import kernel
from elastomer_friction.kernels.model.force import ConstantForce
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Ramp, Slide
from elastomer_friction.kernels.quick.blocks import block_line
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.relaxed import RelaxationForm
from elastomer_friction.kernels.rheology.spectrum import Spectrum
from elastomer_friction.kernels.scene import SCENE_QUANTITIES, run, run_scene
from elastomer_friction.kernels.scene.initial_state import relaxed_elements
from tests.kernels.scene.given import ANY_MOTION, EVERY_LEG, MATERIALS, a_line, a_scene
from tests.sizes import PLAIN_PYTHON, size

WIDE = Spectrum((2.0,) * 7, tuple(np.geomspace(1e-4, 10.0, 7) / 43.3), 0.0)  # fast and slow units
LIFTED = ((0.0, 4.0, 5.0, 9.0, 12.0), (1.0, 1.0, -2.0, -2.0, 1.4))
MOTIONS = {
    "every leg": EVERY_LEG,
    "slide": (Slide(2.0, size(60.0, 6.0)),),
    "reversal": (Slide(0.5, size(20.0, 4.0)), Slide(-3.0, size(30.0, 4.0))),
    "ages": (Slide(0.5, 5.0), Hold(1e6), Slide(0.5, 5.0)),
    "oscillation": (Slide(0.5, 3.3), Oscillation(0.0, 0.3, 1.0, 2), Ramp(0.0, -4.0, 3.0)),
}


def both(monkeypatch, line, scene):
    """Return the values of a scene by the march in blocks and by the march of all elements."""
    result = run_scene(line, scene)
    with monkeypatch.context() as patch:
        patch.setattr(run, "Retardation", RelaxationForm)
        return result, run_scene(line, scene)


def assert_equal(result, plain):
    """Assert that values agree to rounding; sums over all steps have a wider tolerance."""
    for name, values in plain.items():
        scale = np.nanmax(np.abs(values), initial=0.0)
        tolerance = 1e-12 if name == "closing_work" else 1e-13
        np.testing.assert_allclose(
            result[name], values, rtol=0, atol=tolerance * scale, err_msg=name
        )


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("name", [*MATERIALS, "wide"])
def test_a_march_of_few_blocks_equals_that_of_all_elements(monkeypatch, name, motion):
    """Most elements of the long line cannot touch."""
    spectrum = MATERIALS.get(name, WIDE)
    line = a_line(size(400, 40))
    scene = a_scene(
        MOTIONS[motion], spectrum, load=0.05, start="relaxed", requested=("trace", "state")
    )
    assert_equal(*both(monkeypatch, line, scene))


@pytest.mark.parametrize("indentation", [None, LIFTED], ids=["load", "indentation"])
@pytest.mark.parametrize("start", ["steady", "relaxed", "fresh"])
@pytest.mark.parametrize("name", MATERIALS)
def test_all_quantities_equal_those_of_the_march_of_all_elements(
    monkeypatch, name, start, indentation
):
    if start == "fresh" and MATERIALS[name].viscosity > 0.0:
        return
    edges = np.array([0.0, 1.0, 2.0, 4.0, 100.0])
    scene = a_scene(
        EVERY_LEG,
        MATERIALS[name],
        start=start,
        indentation=indentation,
        requested=SCENE_QUANTITIES,
        edges=edges,
    )
    scene = scene._replace(frames=np.arange(0, scene.recorded[-1], 7))
    assert_equal(*both(monkeypatch, a_line(), scene))


@pytest.mark.parametrize("motion", MOTIONS)
def test_the_choice_of_blocks_changes_no_bit(monkeypatch, motion):
    """Energies need all blocks, and shorter stages lead to other choices."""
    line = a_line(size(400, 40))
    scene = a_scene(MOTIONS[motion], WIDE, load=0.05, start="relaxed", requested=("trace", "state"))
    few = run_scene(line, scene)
    every = run_scene(line, scene._replace(requested=ANY_MOTION))
    monkeypatch.setattr("elastomer_friction.kernels.motion.track.MAX_STAGE_STEPS", 13)
    pieces = run_scene(line, scene)
    for name, values in few.items():
        np.testing.assert_array_equal(every[name], values, err_msg=name)
        np.testing.assert_array_equal(pieces[name], values, err_msg=name)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_memory_is_released():
    """Kernels without reference counts leave no allocation behind."""
    line = a_line()
    scene = a_scene(MOTIONS["oscillation"], WIDE, requested=tuple(SCENE_QUANTITIES))
    run_scene(line, scene)
    gc.collect()  # release allocations of earlier tests
    memsys_enable_stats()
    before = rtsys.get_allocation_stats()
    run_scene(line, scene)
    gc.collect()
    after = rtsys.get_allocation_stats()
    assert after.mi_alloc - before.mi_alloc == after.mi_free - before.mi_free > 0


@kernel
def elements_after(body, state, durations):
    """Return the elements after a step that is attempted with several durations, and one before."""
    first, law = Move(0.0, 1.0, 0, False, 0.1), law_in_step(body, state, 0.1)
    state = accept(body, attempt(body, state, law, first), law)
    for dt in durations:
        law = law_in_step(body, state, dt)
        state = attempt(body, state, law, Move(1.0, 2.0, 0, False, 0.1))
    return elements_of(body, accept(body, state, law))


def test_attempts_that_are_not_accepted_leave_no_trace():
    """The memory of every unit decays by up to 1e-20 in the first attempt."""
    line = a_line(size(40, 10))
    form = FORMS_BY_SCHEME["exponential"](MATERIALS["prony"])
    control = ConstantForce(0.3 * line.z.size)
    elements = relaxed_elements(form, line.z, control.load, np.nan)
    ground = shiftable_line(line.z, line.slope, 4.0)
    once, twice = (
        elements_after(*block_line(form, control, ground, elements), np.array(durations))
        for durations in ((0.1,), (10.0, 0.1))
    )
    np.testing.assert_allclose(twice.memory, once.memory, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(twice.p, once.p, rtol=1e-12, atol=1e-13)
