"""Conversion of units in various spellings: mm/min, microns/s, N/mm2, mm·s⁻¹, KHZ, inches."""

import math
import re
import unicodedata
from functools import lru_cache
from typing import NamedTuple

import numpy as np

Dimension = tuple[int, int, int, int, int]  # of length, mass, time, temperature, angle

FAMILIES: dict[Dimension, str] = {
    (1, 0, 0, 0, 0): "length",  # in m
    (0, 0, 1, 0, 0): "time",  # in s
    (1, 0, -1, 0, 0): "velocity",  # in m/s
    (0, 0, -1, 0, 1): "frequency",  # in rad/s
    (0, 0, -1, 0, 0): "rate",  # in 1/s, of cycles or of radians
    (-1, 1, -2, 0, 0): "pressure",  # in Pa
    (1, 1, -2, 0, 0): "force",  # in N
    (0, 0, 0, 1, 0): "temperature",  # in K
    (0, 0, 0, 0, 1): "angle",  # in rad
    (0, 0, 0, 0, 0): "number",  # dimensionless
}
DIMENSIONS = {family: dimension for dimension, family in FAMILIES.items()}
PREFIXES = {"p": 1e-12, "n": 1e-9, "u": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1, "": 1.0}
PREFIXES |= {"h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9}
PREFIX_WORDS = {"pico": 1e-12, "nano": 1e-9, "micro": 1e-6, "milli": 1e-3, "centi": 1e-2, "": 1.0}
PREFIX_WORDS |= {"kilo": 1e3, "mega": 1e6, "giga": 1e9}
INCH = 0.0254
POUND_FORCE = 4.4482216152605  # N
KILOPOND = 9.80665  # N


def _prefixed(symbol: str, prefixes: str, factor: float, family: str) -> dict:
    choices = ("", *prefixes)
    return {f"{prefix}{symbol}": (PREFIXES[prefix] * factor, family) for prefix in choices}


def _spelled(words: str, factor: float, family: str) -> dict:
    return {
        f"{prefix}{word}{end}": (scale * factor, family)
        for prefix, scale in PREFIX_WORDS.items()
        for word in words.split()
        for end in ("", "s")
    }


def _words(words: str, factor: float, family: str) -> dict:
    return dict.fromkeys(words.split(), (factor, family))


KNOWN_UNITS: dict[str, tuple[float, str]] = {
    **_prefixed("m", "pnumcdk", 1.0, "length"),
    **_spelled("meter metre", 1.0, "length"),
    **_words("micron microns mic", 1e-6, "length"),
    **_words("Å å angstrom angstroms ångström ångstrom", 1e-10, "length"),
    **_words("in inch inches", INCH, "length"),
    **_words("mil mils thou", 1e-3 * INCH, "length"),
    **_words("uin microinch microinches", 1e-6 * INCH, "length"),
    **_words("ft foot feet", 12.0 * INCH, "length"),
    **_prefixed("s", "num", 1.0, "time"),
    **_prefixed("sec", "num", 1.0, "time"),
    **_words("secs", 1.0, "time"),
    **_spelled("second", 1.0, "time"),
    **_words("min mins minute minutes", 60.0, "time"),
    **_words("h hr hrs hour hours", 3600.0, "time"),
    **_words("d day days", 86400.0, "time"),
    **_prefixed("Hz", "mkM", 2.0 * math.pi, "frequency"),
    **_spelled("hertz", 2.0 * math.pi, "frequency"),
    **_words("rpm", 2.0 * math.pi / 60.0, "frequency"),
    **_prefixed("rad", "m", 1.0, "angle"),
    **_words("radian radians", 1.0, "angle"),
    **_words("deg ° degree degrees", math.pi / 180.0, "angle"),
    **_words("cycle cycles rev revs turn turns", 2.0 * math.pi, "angle"),
    **_prefixed("Pa", "umhkMG", 1.0, "pressure"),
    **_spelled("pascal", 1.0, "pressure"),
    **_prefixed("bar", "mk", 1e5, "pressure"),
    **_words("psi", POUND_FORCE / INCH**2, "pressure"),
    **_words("ksi", 1e3 * POUND_FORCE / INCH**2, "pressure"),
    **_words("dyn dyne dynes", 1e-5, "force"),
    **_prefixed("N", "numkM", 1.0, "force"),
    **_spelled("newton", 1.0, "force"),
    **_words("kgf kp", KILOPOND, "force"),
    **_words("gf", 1e-3 * KILOPOND, "force"),
    **_words("lbf lb lbs", POUND_FORCE, "force"),
    **_words("kmh kph", 1.0 / 3.6, "velocity"),
    **_words("mph", 0.44704, "velocity"),
    **_words("K kelvin", 1.0, "temperature"),
    **_words("1 - . \u2013 \u2014 # none dimensionless unitless", 1.0, "number"),
    **_words("%", 0.01, "number"),
}
FOLDED_UNITS = {
    word.lower(): entry for word, entry in reversed(KNOWN_UNITS.items()) if len(word) > 1
} | {name.lower(): KNOWN_UNITS[name] for name in ("MPa", "MHz", "s")}
ZERO = 273.15  # K at 0 °C
CELSIUS = ("°c", "c", "degc", "deg c", "deg. c", "celsius", "degrees celsius", "ºc", "oc")
FAHRENHEIT = ("°f", "degf", "deg f", "fahrenheit")
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
SCALED_UNIT = re.compile(
    r"[x×*]?\s*(?:10(?:\^|(?=[⁰-⁹⁻¹²³]))|1?[eE])([-+⁻]?[\d⁰-⁹¹²³]+)\s*[*·×x]?\s*(\D.*)"
)
CLOCK_WORDS = ("PM", "AM")  # of a time of day; PM is not picometre
UNIT_FACTOR = re.compile(r"([^\W\d_]+|[%°#–—-]|1(?!\d))\^?\(?([+-]?\d+)?\)?")  # noqa: RUF001


class Unit(NamedTuple):
    """Known unit: value * factor + offset is in SI units, frequencies in rad/s."""

    text: str  # as written
    family: str  # one of FAMILIES: length, time, velocity, frequency, rate, pressure …
    factor: float
    offset: float = 0.0

    def si(self, values: np.ndarray) -> np.ndarray:
        """Return values in SI units; angular frequencies in rad/s, temperatures in K."""
        return values * self.factor + self.offset if self.offset else values * self.factor


@lru_cache(maxsize=1000)
def unit_of(text: str) -> Unit | None:
    """Return the unit with this spelling, or None if it is unknown.

    Products and quotients of known units are known, of the family "other" if their dimension is
    not in FAMILIES. Letter case matters only if it distinguishes units, such as mPa and MPa.
    """
    scaled = SCALED_UNIT.fullmatch(text.strip().strip("[](){}<>"))
    if scaled:
        base = unit_of(scaled[2])
        power = int(scaled[1].translate(SUPERSCRIPTS))
        return base and base._replace(text=text, factor=base.factor * 10.0**power)
    plain = _normalised(text)
    if plain.lower() in CELSIUS:
        return Unit(text, "temperature", 1.0, ZERO)
    if plain.lower() in FAHRENHEIT:
        return Unit(text, "temperature", 5.0 / 9.0, 459.67 * 5.0 / 9.0)
    if not plain or plain in CLOCK_WORDS:
        return None
    if plain in KNOWN_UNITS:
        factor, family = KNOWN_UNITS[plain]
        return Unit(text, family, factor)
    factor, dimension, single = 1.0, np.zeros(5, int), "/" not in plain and "*" not in plain
    for number, part in enumerate(plain.split("/")):
        for word in filter(None, part.split("*")):
            match = UNIT_FACTOR.fullmatch(word)
            known = match and _unit_factor(match[1], single)
            if not match or not known:
                return None
            power = int(match[2] or 1) * (1 if number == 0 else -1)
            factor *= known[0] ** power
            dimension += power * np.array(DIMENSIONS[known[1]])
    return Unit(text, FAMILIES.get(tuple(dimension.tolist()), "other"), factor)


def _unit_factor(word: str, single: bool) -> tuple[float, str] | None:
    """Return factor and family of a word. M means metre in M/S, but not on its own."""
    if word in KNOWN_UNITS:
        return KNOWN_UNITS[word]
    if word == "M" and not single:
        return KNOWN_UNITS["m"]
    return FOLDED_UNITS.get(word.lower())


def _normalised(text: str) -> str:
    """Return a unit in normalised spelling: u for micro, * between factors, / for per."""
    word = unicodedata.normalize("NFKC", text.strip().strip("[](){}<>").strip())
    word = word.replace("μ", "u").replace("\u2212", "-").replace("**", "^")
    word = re.sub(r"\s+per\s+|\s*/\s*", "/", word)
    if word.lower() in CELSIUS or word.lower() in FAHRENHEIT:
        return word
    return re.sub(r"\s*[·⋅×*•]\s*|\s+|(?<=[a-z])\.(?=[a-z])", "*", word)
