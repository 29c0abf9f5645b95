"""Comparison with the contact package tamaas for two branches, sliding forth and back.

tamaas steps a branch, a spring g with relaxation time t, by backward Euler: the new stress is
(s + g du) t / (t + dt). In the relaxation form it is E s + g phi du. For equal steps both agree if
tamaas is given the time E dt / (1 - E) and the modulus g phi / E. Contact, memory and balance are
then solved by two independent programs.
(tamaas: J. Open Source Softw. 5, 2121 (2020); see test_tamaas.py.)
"""

import numpy as np
import pytest

from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Slide
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import law_of
from elastomer_friction.kernels.rheology.spectrum import Spectrum
from elastomer_friction.kernels.scene import SavedState, run_scene
from tests.kernels.scene.given import a_scene
from tests.lines import random_line

tamaas = pytest.importorskip("tamaas", reason="needs the extra 'verify': pip install '.[verify]'")

tamaas.set_log_level(tamaas.LogLevel.warning)  # print no table of every solution

SPECTRUM = Spectrum((2.0, 5.0), (0.8, 0.1), 0.0)
ELEMENTS, LOAD, SPEED = 1000, 0.02, 4.0
FORTH, BACK = 60, 40  # steps
TOLERANCE = 1e-6


def by_tamaas(line):
    """Return mu at the end of every step; initially the foundation has no memory."""
    law = law_of(FORMS_BY_SCHEME["implicit-euler"](SPECTRUM), 1.0 / SPEED)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [1.0], [line.z.size])
    model.nu, model.E = 0.0, 2.0  # shear modulus 1, that of the spring
    times = law.decay / (1.0 - law.decay) / SPEED
    branches = (law.gain / law.decay).tolist(), times.tolist()
    solver = tamaas.MaxwellViscoelastic(model, -line.z, 1e-14, 1.0 / SPEED, *branches)
    for name in ("Westergaard::neumann", "westergaard_neumann"):
        model.operators[name]["influence"][...] = 1.0
    mu = []
    for place in [*range(1, FORTH + 1), *range(FORTH - 1, FORTH - BACK - 1, -1)]:
        solver.surface[:] = -np.roll(line.z, place)
        solver.solve(LOAD)
        forces = np.array(model.traction)
        mu.append(float(forces @ np.roll(line.slope, place) / forces.sum()))
    return mu


def test_two_branches_forth_and_back():
    line = Line.from_samples(*random_line(ELEMENTS, 0.7, 1, seed=1), 1)
    nothing = np.zeros(line.z.size)
    untouched = SavedState(np.zeros((3, line.z.size)), nothing, 0.0, 0.0, 0.0, 0.0)
    scene = a_scene(
        (Slide(SPEED, FORTH), Slide(-SPEED, BACK)),
        SPECTRUM,
        1,
        scheme="implicit-euler",
        load=LOAD,
        start="relaxed",
        recorded=np.arange(1, FORTH + BACK + 1),
    )
    mu = run_scene(line, scene, untouched)["trace_mu"]
    np.testing.assert_allclose(by_tamaas(line), mu, rtol=0.0, atol=TOLERANCE * np.ptp(mu))
    assert mu[-1] < 0.0 < mu[FORTH - 1]  # friction changes enough for the test
