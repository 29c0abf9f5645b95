"""The general path of a case: against the quick one, its limits and its symmetry."""

import numpy as np
import pytest

from kernels import Case, Line, Quantities, Spectrum, amplitudes, draw_phases, run_case
from kernels.memory_case import run_memory_case

LINE = Line.self_affine(amplitudes(0.7, 64), draw_phases(np.random.default_rng(2), 64), 64, 8)
MIRROR = Line.from_samples(LINE.z[::-1].copy(), -LINE.slope[::-1], 8)
KEPT = np.array([1, 2, 5, 20, 100, 400])
CASE = Case(0.3, 2.0, (1.5,), (KEPT,), "exponential")
SOLID = CASE._replace(spectrum=Spectrum((8.0,), (0.125,), 0.0))
ASKED = Quantities(initial_rate=True)


def test_a_kelvin_element_has_the_march_of_the_quick_path():
    quick, general = run_case(LINE, CASE, ASKED), run_memory_case(LINE, CASE, ASKED)
    relaxed = [found.curves[0] - found.mu_2[0] for found in (quick, general)]
    assert relaxed[1] == pytest.approx(relaxed[0], abs=1e-11)
    assert general.indentation == pytest.approx(quick.indentation, rel=1e-12)
    assert general.mu_1 == pytest.approx(quick.mu_1, rel=0.05)  # other quadratures
    assert general.jump[0] == pytest.approx(quick.jump[0], rel=0.05)


def test_without_a_dashpot_friction_rises_from_where_it_was_to_its_new_value():
    found = run_case(LINE, SOLID, ASKED)
    assert found.jump[0] == 0.0
    assert found.initial_rate[0] > 0.0
    step = 1.0 / (8 * 3.0)
    assert found.mu_1 < found.curves[0][0] < found.mu_1 + 1.1 * step * found.initial_rate[0]
    assert found.curves[0].max() > max(found.curves[0][0], found.mu_2[0])
    assert found.curves[0][-1] == pytest.approx(found.mu_2[0], rel=0.02)


def test_the_mirror_image_slides_back():
    there, back = run_case(LINE, SOLID, ASKED), run_case(MIRROR, SOLID._replace(speed=-2.0), ASKED)
    assert back.mu_1 == pytest.approx(-there.mu_1, rel=1e-9)
    assert back.mu_2 == pytest.approx(-there.mu_2, rel=1e-9)
    assert back.curves[0] == pytest.approx(-there.curves[0], abs=1e-9)
    assert back.contact_fraction == there.contact_fraction


def test_only_what_is_asked_for_is_there():
    found = run_case(LINE, SOLID, Quantities(jump=False, relaxation=False))
    assert np.isfinite(found.mu_2).all()
    assert np.isnan(found.jump).all()
    assert not found.curves
