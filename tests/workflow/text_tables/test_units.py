"""Units as people write them, and words that are none."""

import math

import numpy as np
import pytest

from elastomer_friction.workflow.text_tables import unit_of


@pytest.mark.parametrize(
    ("written", "family", "factor"),
    [
        *((unit, "length", 1e-6) for unit in ("um", "µm", "μm", "UM", "micrometres", "Microns")),
        *((unit, "length", 0.0254) for unit in ("in", "inch", "Inches")),
        *((unit, "length", 2.54e-5) for unit in ("mil", "mils", "thou")),
        *((unit, "length", 1e-10) for unit in ("\u00c5", "\u212b", "Angstrom")),
        *((unit, "velocity", 1e-3) for unit in ("mm/s", "mm·s⁻¹", "mm s^-1", "MM/S", "mm per sec")),
        *((unit, "velocity", 1e-3 / 60.0) for unit in ("mm/min", "mm min-1")),
        ("microns/s", "velocity", 1e-6),
        ("km/h", "velocity", 1.0 / 3.6),
        ("kHz", "frequency", 2e3 * math.pi),
        ("HZ", "frequency", 2.0 * math.pi),
        ("rad/s", "frequency", 1.0),
        ("rad s⁻¹", "frequency", 1.0),
        ("1/s", "rate", 1.0),
        *((unit, "pressure", 1e6) for unit in ("MPa", "MPA", "N/mm2", "N/mm²", "N mm^-2", "MN/m2")),
        *((unit, "pressure", 1e6) for unit in ("10^6 Pa", "x10⁶ Pa", "1e6 Pa", "E+3 kPa")),
        ("10⁻³ m/s", "velocity", 1e-3),
        ("mPa", "pressure", 1e-3),
        ("dyn/cm2", "pressure", 0.1),
        ("psi", "pressure", 6894.757),
        ("ms", "time", 1e-3),
        ("%", "number", 0.01),
        ("-", "number", 1.0),
        ("[ mN ]", "force", 1e-3),
    ],
)
def test_units(written, family, factor):
    unit = unit_of(written)
    assert unit is not None
    assert (unit.family, unit.factor) == (family, pytest.approx(factor))


@pytest.mark.parametrize(("written", "kelvin"), [("°C", 293.15), ("degF", 266.483), ("K", 20.0)])
def test_temperatures_have_an_origin(written, kelvin):
    unit = unit_of(written)
    assert unit is not None
    np.testing.assert_allclose(unit.si(np.array([20.0])), kelvin, atol=1e-3)


VAST = ("10^400 m", "10^-400 m", "m^99", f"10^{'9' * 5000} m", "10^300 Gm9", "10^1 " * 2000 + "m")


@pytest.mark.parametrize(
    "word", ["", "M", "PM", "Raw", "V", "a", "Lateral", "mm/V", "x/y", *VAST, "*".join(["Gm9"] * 9)]
)
def test_other_words_are_no_units(word):
    assert unit_of(word) is None


def test_products_of_other_dimensions_are_units():
    assert [getattr(unit_of(word), "family", "") for word in ("mm*s", "N m")] == ["other", "other"]


# NIST Special Publication 811 (2008), appendix B.8.
FACTORS = {
    **{"ft": 0.3048, "feet": 0.3048, "uin": 2.54e-8, "pm": 1e-12, "nm": 1e-9, "cm": 1e-2},
    **{"dm": 0.1, "km": 1e3, "kilometers": 1e3, "centimetre": 1e-2, "h": 3600.0, "days": 86400.0},
    **{"min": 60.0, "us": 1e-6, "nsec": 1e-9, "rpm": 0.1047198, "mHz": 6.283185e-3},
    **{"gigahertz": 6.283185e9, "deg": 0.01745329, "°": 0.01745329, "rev": 6.283185, "mrad": 1e-3},
    **{"bar": 1e5, "mbar": 100.0, "ksi": 6.894757e6, "hPa": 100.0, "kgf": 9.80665, "lbf": 4.448222},
    **{"gf": 9.80665e-3, "dyne": 1e-5, "mph": 0.44704, "kph": 0.2777778, "ft/min": 5.08e-3},
}


@pytest.mark.parametrize("written", FACTORS)
def test_factors_are_those_of_nist(written):
    unit = unit_of(written)
    assert unit is not None
    assert unit.factor == pytest.approx(FACTORS[written], rel=1e-6)
