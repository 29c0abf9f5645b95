"""The table [material]: branches sorted and merged, tau, spectrum, shift with temperature."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import Wlf
from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from elastomer_friction.workflow.study.effects.material import MATERIAL, Material, read_material
from elastomer_friction.workflow.study.settings import checked
from tests.support.small import small_study

BRANCHES = [[5e6, 1e-2], [1e7, 1e-3]]
WLF = {"c1": 8.86, "c2": 101.6, "reference": 20.0}
PAIRS = st.lists(st.tuples(st.floats(1e3, 1e9), st.floats(1e-9, 1e3)), min_size=1, max_size=8)


def read(tmp_path, **given):
    table = checked("material", {"shear_modulus": 1e6} | given, MATERIAL)
    return read_material("material", table, tmp_path)


def test_a_kelvin_element_is_the_dashpot_alone(tmp_path):
    material = read(tmp_path, relaxation_time=2e-3)
    assert material == Material(1e6, 2e-3)
    assert (material.tau, material.jumps) == (2e-3, True)
    assert material.spectrum() == ((), (), 1.0)


def test_tau_is_the_viscosity_at_rest_over_the_modulus(tmp_path):
    material = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3)
    assert material.tau == pytest.approx(1e-3 + (5e6 * 1e-2 + 1e7 * 1e-3) / 1e6, rel=1e-15)
    assert material.branches == ((1e7, 1e-3), (5e6, 1e-2))
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
    actual = complex_modulus(material.spectrum(), np.array([omega * material.tau]))[0]
    wanted = 1.0 + 1j * omega * dashpot
    wanted += sum(g / 1e6 * 1j * omega * t / (1.0 + 1j * omega * t) for g, t in pairs)
    assert actual == pytest.approx(wanted, rel=1e-9)


SHARES = "0.125, 0.01\n0.25, 0.001\n"  # of 1.6 times the relaxed modulus
BY_ABAQUS = "*VISCOELASTIC, TIME=PRONY\n0.125, 0, 0.01\n0.25, 0, 0.001\n"


@pytest.mark.parametrize(
    ("text", "moduli"),
    [
        ("5, 1e-2\n10, 1e-3\n", (10.0, 5.0)),
        ("modulus [MPa], time [ms]\n5, 10\n10, 1\n", (1e7, 5e6)),
        ("tau (s), G (kPa)\n1e-2, 5\n1e-3, 10\n", (1e4, 5e3)),
        ("t_b / ms; g_b / N/mm2\n10; 5\n1; 10\n", (1e7, 5e6)),
        ("E_i [MPa], tau_i [s]\n5, 1e-2\n10, 1e-3\n", (1e7 / 3.0, 5e6 / 3.0)),
        (f"alpha_i, tau_i\n{SHARES}", (4e6, 2e6)),
        (f"g_i, tau_i (s)\n{SHARES}", (4e6, 2e6)),
        ("tau, share\n1e-2, 0.125\n1e-3, 0.25\n", (4e6, 2e6)),
        (f"G_i/G_0, tau_i\n{SHARES}", (4e6, 2e6)),
        (BY_ABAQUS, (4e6, 2e6)),
    ],
)
def test_order_units_and_shares_of_a_file_of_branches(tmp_path, text, moduli):
    (tmp_path / "branches.csv").write_text(text)
    actual = read(tmp_path, shear_modulus=1e7, branches_file="branches.csv")
    np.testing.assert_allclose([g for g, _ in actual.branches], moduli, rtol=1e-12)
    np.testing.assert_allclose([t for _, t in actual.branches], [1e-3, 1e-2], rtol=1e-12)


def test_a_temperature_shifts_all_times_once_and_for_all(tmp_path):
    at_reference = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3)
    warm = read(tmp_path, branches=BRANCHES, relaxation_time=1e-3, wlf=WLF, temperature=50.0)
    factor = 10.0 ** (-8.86 * 30.0 / 131.6)
    assert warm.tau == pytest.approx(factor * at_reference.tau, rel=1e-12)
    np.testing.assert_allclose(warm.spectrum().times, at_reference.spectrum().times, rtol=1e-12)


def test_the_law_of_arrhenius_is_a_line_over_the_inverse_temperature(tmp_path):
    law = {"activation_energy": 1e5, "reference": 20.0}
    taus = [
        read(tmp_path, relaxation_time=1e-3, arrhenius=law, temperature=t).tau
        for t in (0.0, 20.0, 60.0)
    ]
    inverse = 1.0 / (273.15 + np.array([0.0, 20.0, 60.0]))
    slopes = np.diff(np.log(taus)) / np.diff(inverse)
    np.testing.assert_allclose(slopes, 1e5 / 8.314462618, rtol=1e-12)
    assert taus[1] == 1e-3


@pytest.mark.parametrize(
    "text",
    [
        "20 0\n0 2\n50 -1.5\n",
        "T (K), log10(aT)\n273.15, 2\n293.15, 0\n323.15, -1.5\n",
        "shift a_T; temperature (°C)\n100; 0\n1; 20\n0.0316227766; 50\n",
        "T [°C], shift\n0, 2\n20, 0\n50, -1.5\n",  # decades, as a_T is named
        "T [°C], shift factor\n0, 100\n20, 1\n50, 0.0316227766\n",
        "T [°C], ln a_T\n0, 4.605170186\n20, 0\n50, -3.453877639\n",
    ],
)
def test_a_table_of_shifts_is_linear_in_between(tmp_path, text):
    (tmp_path / "shifts.txt").write_text(text, encoding="utf-8")
    given_as = {"shifts_file": "shifts.txt"}
    for temperature, decades in ((0.0, 2.0), (10.0, 1.0), (20.0, 0.0), (35.0, -0.75), (50.0, -1.5)):
        actual = read(tmp_path, relaxation_time=1e-3, temperature=temperature, **given_as)
        assert math.log10(actual.tau / 1e-3) == pytest.approx(decades, abs=1e-8)


def test_a_comparison_shifts_by_another_law(tmp_path):
    study = small_study(
        "material.shifts=[[0, 2], [20, 0]]",
        "material.temperature=10",
        "compare.other.arrhenius={activation_energy=1e5, reference=20}",
    )
    assert study.material.shift_factor == pytest.approx(10.0, rel=1e-12)
    assert study.materials["other"].shifts is None
    assert 1.0 < study.materials["other"].shift_factor < 10.0


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
