"""Conversion of units in various spellings: mm/min, microns/s, N/mm2, mm·s⁻¹, KHZ, inches."""

import math
import re
import unicodedata
from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

import numpy as np

MAX_UNIT_CHARACTERS = 60
FAMILIES: dict[tuple[int, ...], str] = {  # powers of length, mass, time, temperature, angle
    (1, 0, 0, 0, 0): "length",  # in m
    (0, 0, 1, 0, 0): "time",  # in s
    (1, 0, -1, 0, 0): "velocity",  # in m/s
    (0, 0, -1, 0, 1): "frequency",  # in rad/s
    (0, 0, -1, 0, 0): "rate",  # in 1/s, of cycles or of radians
    (-1, 1, -2, 0, 0): "pressure",  # in Pa
    (1, 1, -2, 0, 0): "force",  # in N
    (0, 0, 0, 1, 0): "temperature",  # in K
    (0, 0, 0, 0, 1): "angle",  # in rad
    (-1, 0, 0, 0, 0): "wave number",  # in rad/m
    (-1, 0, 0, 0, 1): "wave number",
    (4, 0, 0, 0, 0): "spectrum of a surface",  # in m^4
    (3, 0, 0, 0, 0): "spectrum of a line",  # in m^3
    (0, 0, 0, 0, 0): "number",  # dimensionless
}
DIMENSIONS = {family: dimension for dimension, family in FAMILIES.items()}
PREFIXES = {"": 1.0, "p": 1e-12, "n": 1e-9, "u": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1}
PREFIXES |= {"h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9}
PREFIX_WORDS = {"pico": 1e-12, "nano": 1e-9, "micro": 1e-6, "milli": 1e-3, "centi": 1e-2}
PREFIX_WORDS |= {"kilo": 1e3, "mega": 1e6, "giga": 1e9}
INCH = 0.0254
POUND_FORCE = 4.4482216152605  # N
KILOPOND = 9.80665  # N


def _units(words: str, factor: float, family: str, prefixes: Iterable[str] = ()) -> dict:
    """Return the entries of KNOWN_UNITS for words, without prefix and with each of ``prefixes``."""
    factors = {prefix: (PREFIXES | PREFIX_WORDS)[prefix] * factor for prefix in ("", *prefixes)}
    return {f"{p}{word}": (factors[p], family) for p in factors for word in words.split()}


KNOWN_UNITS: dict[str, tuple[float, str]] = {
    **_units("m meter metre meters metres", 1.0, "length", (*"pnumcdk", *PREFIX_WORDS)),
    **_units("micron microns mic", 1e-6, "length"),
    **_units("Å å angstrom angstroms ångström ångstrom", 1e-10, "length"),
    **_units("in inch inches", INCH, "length"),
    **_units("mil mils thou", 1e-3 * INCH, "length"),
    **_units("uin microinch microinches", 1e-6 * INCH, "length"),
    **_units("ft foot feet", 12.0 * INCH, "length"),
    **_units("s sec secs second seconds", 1.0, "time", (*"num", *PREFIX_WORDS)),
    **_units("min mins minute minutes", 60.0, "time"),
    **_units("h hr hrs hour hours", 3600.0, "time"),
    **_units("d day days", 86400.0, "time"),
    **_units("Hz", 2.0 * math.pi, "frequency", "mkM"),
    **_units("hertz", 2.0 * math.pi, "frequency", PREFIX_WORDS),
    **_units("rpm", 2.0 * math.pi / 60.0, "frequency"),
    **_units("rad radian radians", 1.0, "angle", "m"),
    **_units("deg ° degree degrees", math.pi / 180.0, "angle"),
    **_units("cycle cycles rev revs turn turns", 2.0 * math.pi, "angle"),
    **_units("Pa", 1.0, "pressure", "umhkMG"),
    **_units("pascal pascals", 1.0, "pressure", PREFIX_WORDS),
    **_units("bar", 1e5, "pressure", "mk"),
    **_units("psi", POUND_FORCE / INCH**2, "pressure"),
    **_units("ksi", 1e3 * POUND_FORCE / INCH**2, "pressure"),
    **_units("dyn dyne dynes", 1e-5, "force"),
    **_units("N", 1.0, "force", "numkM"),
    **_units("newton newtons", 1.0, "force", PREFIX_WORDS),
    **_units("kgf kp", KILOPOND, "force"),
    **_units("gf", 1e-3 * KILOPOND, "force"),
    **_units("lbf lb lbs", POUND_FORCE, "force"),
    **_units("kmh kph", 1.0 / 3.6, "velocity"),
    **_units("mph", 0.44704, "velocity"),
    **_units("K kelvin", 1.0, "temperature"),
    **_units("1 - . \u2013 \u2014 # none dimensionless unitless", 1.0, "number"),
    **_units("%", 0.01, "number"),
}
FOLDED_UNITS = {
    word.lower(): entry for word, entry in reversed(KNOWN_UNITS.items()) if len(word) > 1
} | {name.lower(): KNOWN_UNITS[name] for name in ("MPa", "MHz", "s")}
ZERO = 273.15  # K at 0 °C
TEMPERATURES = {  # normalised spelling in lower case -> factor, offset in K
    **dict.fromkeys(("°c", "c", "degc", "deg*c", "deg.*c", "ºc", "oc"), (1.0, ZERO)),
    **dict.fromkeys(("celsius", "degrees*celsius"), (1.0, ZERO)),
    **dict.fromkeys(("°f", "degf", "deg*f", "fahrenheit"), (5.0 / 9.0, 459.67 * 5.0 / 9.0)),
}
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
SCALED_UNIT = re.compile(
    r"[x×*]?\s*(?:10(?:\^|(?=[⁰-⁹⁻¹²³]))|1?[eE])([-+⁻]?[\d⁰-⁹¹²³]{1,3})\s*[*·×x]?\s*(\D.*)"
)
CLOCK_UNIT = re.compile(r"h+:m(m|in)?:s+([.,*]\w+)?", re.IGNORECASE)  # of a time of day
CLOCK_WORDS = ("PM", "AM")  # of a time of day; PM is not picometre
UNIT_FACTOR = re.compile(r"([^\W\d_]+|[%°]|1(?!\d))\^?\(?([+-]?\d)?\)?")


class Unit(NamedTuple):
    """Known unit: value * factor + offset is in SI units, frequencies in rad/s."""

    text: str  # as written
    family: str  # one of FAMILIES: length, time, velocity, frequency, rate, pressure …
    factor: float
    offset: float = 0.0

    def si(self, values: np.ndarray) -> np.ndarray:
        """Return values in SI units; angular frequencies in rad/s, temperatures in K."""
        return values * self.factor + self.offset if self.offset else values * self.factor


@lru_cache(maxsize=100_000)
def unit_of(text: str) -> Unit | None:
    """Return the unit with this spelling, or None if it is unknown.

    Products and quotients of known units are known, of the family "other" if their dimension is
    not in FAMILIES. Letter case matters only if it distinguishes units, such as mPa and MPa.
    """
    if len(text) > MAX_UNIT_CHARACTERS:
        return None
    scaled = SCALED_UNIT.fullmatch(text.strip().strip("[](){}<>"))
    plain = _normalised(scaled[2] if scaled else text)
    if plain.lower() in TEMPERATURES:
        return Unit(text, "temperature", *TEMPERATURES[plain.lower()])
    if CLOCK_UNIT.fullmatch(plain):
        return Unit(text, "time", 1.0)
    if not plain or plain in CLOCK_WORDS:
        return None
    factor, dimension, single = 1.0, np.zeros(5, int), "/" not in plain and "*" not in plain
    for number, part in enumerate([plain] if plain in KNOWN_UNITS else plain.split("/")):
        for word in part.split("*") if part else ():
            match = UNIT_FACTOR.fullmatch(word)
            symbol = match[1] if match else plain  # such as -
            if symbol == "M" and not single:  # M means metre in M/S, but not on its own
                symbol = "m"
            known = KNOWN_UNITS.get(symbol, FOLDED_UNITS.get(symbol.lower()))
            if not known:
                return None
            power = int((match and match[2]) or 1) * (1 if number == 0 else -1)
            factor *= known[0] ** power
            dimension += power * np.array(DIMENSIONS[known[1]])
    factor *= float(f"1e{scaled[1].translate(SUPERSCRIPTS)}") if scaled else 1.0
    family = FAMILIES.get(tuple(dimension.tolist()), "other")
    return Unit(text, family, factor) if 0.0 < factor < math.inf else None


def _normalised(text: str) -> str:
    """Return a unit in normalised spelling: u for micro, * between factors, / for per."""
    word = unicodedata.normalize("NFKC", text.strip().strip("[](){}<>").strip())
    word = word.replace("μ", "u").replace("\u2212", "-").replace("**", "^")
    word = re.sub(r"\s+per\s+|\s*/\s*", "/", word)
    return re.sub(r"\s*[·⋅×*•]\s*|\s+|(?<=[a-z])\.(?=[a-z])", "*", word)
