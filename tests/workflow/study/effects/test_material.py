"""The table [material]: branches sorted and merged, tau, spectrum, shift with temperature."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from elastomer_friction.workflow.study.effects.material import (
    MATERIAL,
    Material,
    Wlf,
    read_material,
)
from elastomer_friction.workflow.study.settings import checked
from tests.support.small import FILES, small_study

BRANCHES = [[5e6, 1e-2], [1e7, 1e-3]]
WLF = {"c1": 8.86, "c2": 101.6, "reference": 20.0}
PAIRS = st.lists(st.tuples(st.floats(1e3, 1e9), st.floats(1e-9, 1e3)), min_size=1, max_size=8)


def read(tmp_path, **given):
    table = checked("material", {"shear_modulus": 1e6} | given, MATERIAL)
    return read_material("material", table, tmp_path)


def test_a_kelvin_element_is_the_dashpot_alone(tmp_path):
    material = read(tmp_path, relaxation_time=2e-3)
    assert material == Material(1e6, 2e-3)
    assert (material.tau, material.longest_time, material.jumps) == (2e-3, 2e-3, True)
    assert material.spectrum() == ((), (), 1.0)


def test_tau_is_the_viscosity_at_rest_over_the_modulus(tmp_path):
    material = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3)
    assert material.tau == pytest.approx(1e-3 + (5e6 * 1e-2 + 1e7 * 1e-3) / 1e6, rel=1e-15)
    assert material.branches == ((1e7, 1e-3), (5e6, 1e-2))
    assert material.longest_time == 1e-2
    assert not read(tmp_path, branches=BRANCHES).jumps


@given(PAIRS, st.randoms())
def test_neither_order_nor_a_split_of_a_branch_matters(pairs, random):
    own = read(None, branches=[list(p) for p in pairs])
    halves = [[g / 2.0, t] for g, t in pairs for _ in range(2)]
    random.shuffle(halves)
    other = read(None, branches=halves)
    np.testing.assert_allclose(own.branches, other.branches, rtol=1e-14)
    times = [time for _, time in own.branches]
    assert times == sorted(times)
    assert own.tau == pytest.approx(other.tau, rel=1e-12)


@given(PAIRS, st.floats(1e-3, 1e3), st.floats(0.0, 1.0))
def test_the_spectrum_has_the_same_complex_modulus(pairs, frequency, dashpot):
    given_branches = [list(pair) for pair in pairs]
    material = read(None, branches=given_branches, relaxation_time=dashpot)
    omega = 2.0 * math.pi * frequency
    found = complex_modulus(material.spectrum(), np.array([omega * material.tau]))[0]
    wanted = 1.0 + 1j * omega * dashpot
    wanted += sum(g / 1e6 * 1j * omega * t / (1.0 + 1j * omega * t) for g, t in pairs)
    assert found == pytest.approx(wanted, rel=1e-9)


def test_branches_of_a_file(tmp_path):
    (tmp_path / "branches.csv").write_text(FILES["branches.csv"])
    assert read(tmp_path, branches_file="branches.csv") == read(tmp_path, branches=BRANCHES)


def test_a_temperature_shifts_all_times_once_and_for_all(tmp_path):
    at_reference = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3)
    warm = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3, wlf=WLF, temperature=50.0)
    factor = 10.0 ** (-8.86 * 30.0 / 131.6)
    assert warm.tau == pytest.approx(factor * at_reference.tau, rel=1e-12)
    assert warm.longest_time == pytest.approx(factor * 1e-2, rel=1e-12)
    np.testing.assert_allclose(warm.spectrum().times, at_reference.spectrum().times, rtol=1e-12)


def test_a_list_of_temperatures_is_a_dimension(tmp_path):
    material = read(tmp_path, branches=BRANCHES, wlf=WLF, temperature=20.0)
    assert material.wlf == Wlf(8.86, 101.6, 20.0)
    assert material.tau == read(tmp_path, branches=BRANCHES).tau
    wlf = f"{{c1={WLF['c1']}, c2={WLF['c2']}, reference=20}}"
    study = small_study("material.temperature={linspace=[0, 40, 3]}", f"material.wlf={wlf}")
    assert study.axes[-1] == "temperature"
    assert study.grid["temperature"] == (0.0, 20.0, 40.0)
    assert study.shape[-1] == 3
    cold, at_reference, warm = (p.material.tau for p in study.parts("", ["temperature"]))
    assert cold > at_reference == 1e-3 > warm
