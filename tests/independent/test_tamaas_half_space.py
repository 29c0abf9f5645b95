"""Comparison with tamaas on a half-space: elastic contact, and two branches forth and back.

With branches tamaas requires the shear modulus 1, i.e. E* = 2, so its pressures are twice those of
a half-space with relaxed E* = 1. Times and moduli of the branches are converted to those of the
relaxation form as in test_tamaas_branches.py.
"""

import numpy as np
import pytest

from elastomer_friction.kernels.half_space.body import Body, HalfSpace, Step, take_step
from elastomer_friction.kernels.half_space.contact import Operator, press
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.half_space.waves import half_space_stiffness
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.spectrum import Spectrum

tamaas = pytest.importorskip("tamaas", reason="needs the extra 'verify': pip install '.[verify]'")

tamaas.set_log_level(tamaas.LogLevel.warning)  # print no table of every solution

SPECTRUM = Spectrum((2.0, 5.0), (0.8, 0.1), 0.0)
ELEMENTS, M, PRESSURE, SPEED = 8, 4, 0.05, 1.0
FORTH, BACK = 12, 8  # steps


def a_surface() -> Surface:
    amplitudes = ring_amplitudes(0.7, ELEMENTS)
    return Surface.drawn(np.random.default_rng(1), amplitudes, ELEMENTS, M)


def a_model(n: int):
    side = [float(ELEMENTS)] * 2
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, side, [n, n])
    model.nu, model.E = 0.0, 2.0
    return model


def test_an_elastic_contact_has_the_same_pressures() -> None:
    surface = a_surface()
    n = surface.z.shape[1]
    operator = Operator.of(half_space_stiffness((n, n), M), n)
    p = press(surface.z, PRESSURE, operator, None, 1e-10).p
    model = a_model(surface.z.shape[1])
    tamaas.PolonskyKeerRey(model, -surface.z, 1e-13).solve(2.0 * PRESSURE)
    np.testing.assert_allclose(0.5 * np.array(model.traction), p, rtol=0.0, atol=1e-6 * p.max())


def test_two_branches_forth_and_back_have_the_same_pressures() -> None:
    surface, form = a_surface(), FORMS_BY_SCHEME["implicit-euler"](SPECTRUM)
    space = HalfSpace.under(form, surface, PRESSURE * ELEMENTS)
    law = Step.of(form, surface, SPEED).law
    times = law.decay / (1.0 - law.decay) / (M * SPEED)
    branches = (law.gain / law.decay).tolist(), times.tolist()
    model = a_model(surface.z.shape[1])
    solver = tamaas.MaxwellViscoelastic(model, -surface.z, 1e-12, 1.0 / (M * SPEED), *branches)
    nothing = np.zeros((3, surface.z.size))
    body = Body(nothing, nothing[0], np.full(surface.z.shape, PRESSURE), 0.0, 0)
    for place in [*range(1, FORTH + 1), *range(FORTH - 1, FORTH - BACK - 1, -1)]:
        direction = 1.0 if body.offset < place else -1.0
        body, _ = take_step(space, body, Step.of(form, surface, direction * SPEED), 1e-9)
        assert body.offset == place
        solver.surface[:] = -np.roll(surface.z, place, axis=1).ravel()
        solver.solve(2.0 * PRESSURE)
        theirs, ours = (
            0.5 * np.array(model.traction).reshape(body.p.shape),
            np.roll(body.p, place, axis=1),
        )
        np.testing.assert_allclose(theirs, ours, rtol=0.0, atol=1e-5 * ours.max())
