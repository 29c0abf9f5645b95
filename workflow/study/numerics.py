"""How problems are discretised: the table [numerics]."""

from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

from ...kernels import SCHEMES
from ..ground import UserError
from .settings import Key, choice, filled, integer, within

LONG_HORIZON = 6.0  # below 1 %: beyond 4 expected times b changes by 0.5 %, at worst by 5 %
LONG_BELOW = 0.01
# Beyond the one nothing is in reach, beyond the other no law holds.
ACCURACY = partial(within, least=1e-4, most=0.3, hint=" (0.01 is 1 %)")
AUTO = "auto"
NEGLIGIBLE = 0.01  # share of the jump, where an accuracy is asked for
RECORDS = ("time", "distance", "log")


class Numerics(NamedTuple):
    """How problems are discretised; ``steps_per_spacing = None`` stands for "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    curve_samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # wanted relative error of what is asked for
    max_realizations: int = 10_000  # per point, on the way to the accuracy
    negligible: float = 0.0  # share of the jump; of relaxations below it the rate is not sought
    record: str = "time"  # in what the kept samples of a trace are evenly spaced
    trace: int | None = None  # keep every so many steps instead

    @property
    def refines(self) -> bool:
        """Return whether contacts of steady sliding are followed between the samples.

        Where "auto" chooses the steps. Steps that are given are taken as they are, everywhere, and
        what they do not resolve is marked in the result.
        """
        return self.steps_per_spacing is None


def _steps(key: str, value: object) -> int | None:
    return None if value == AUTO else integer(key, value, 1)


USUAL = Numerics()
NUMERICS = {
    "scheme": Key(
        partial(choice, known=SCHEMES),
        "The time step of an element. `exponential` lets a free element decay by exp(−Δt/τ) and "
        "is of second order; `implicit-euler` lets it decay by 1/(1 + Δt/τ), is of first order, "
        "and with one step per spacing gives the left branch of figure 7. Both converge to the "
        "same.",
        default=USUAL.scheme,
    ),
    "steps_per_spacing": Key(
        _steps,
        "The number m of time steps, and of samples of the line with an element each, per spacing "
        'Δx. With `"auto"` each point takes the least m that keeps the discretisation error of '
        "what is asked for below 2 %, where that can be, and reads steady friction and jump from "
        "between the samples, to 10⁻⁵. It takes 4 for measured lines and 8 for "
        "branches and programmes, whose errors follow no known law. A number is taken as it is at "
        "every point, "
        "and `resolution_status` marks contacts that it does not resolve.",
        "Doubled, the error of µ₁ falls to about a third, those of Δµ₀ and b to about half; "
        "steady states take twice the time, relaxation up to four times.",
        default=None,
        values='a whole number, at least 1, or `"auto"`',
        usual='`"auto"`',
        schema={"anyOf": [{"const": AUTO}, {"type": "integer", "minimum": 1}]},
    ),
    "samples": Key(
        partial(integer, least=8, most=10_000),
        "The number of points that are kept of each relaxation curve or trace.",
        "Doubled, the file is larger, and the fit of eq. 6 rests on more points and changes "
        "slightly.",
        default=USUAL.curve_samples,
        usual="64; 200 in `scene.run`",
    ),
    "horizon": Key(
        partial(within, least=1.0, most=100.0),
        "How long the relaxation is followed, in expected relaxation times.",
        "Doubled, the march takes twice as many steps; beyond 4 the rate changes by about 0.5 %.",
        default=None,
        usual="4; 6 where `accuracy` is below 1 %",
    ),
    "accuracy": Key(
        ACCURACY,
        "The wanted relative error of µ₁, Δµ₀ and b, as far as they are asked for: standard error "
        "plus bound of the discretisation error. The program chooses m and the number of lines "
        "for it, in place of `study.realizations`.",
        "Doubled, it takes a quarter of the lines, and often fewer steps.",
        default=None,
    ),
    "max_realizations": Key(
        partial(integer, least=1),
        "With `accuracy`, the number of lines at which a point ends even if it has not reached "
        "it; the result says where.",
        "Doubled, points that are hard to determine may take twice the time for an error smaller "
        "by √2.",
        default=USUAL.max_realizations,
    ),
    "negligible": Key(
        partial(within, least=0.0, most=1.0),
        "A share of the jump Δµ₀. Where surely less than this share relaxes, no line is added to "
        "determine b, and `fit_status` says `negligible`.",
        "Doubled, b is left undetermined at more points with x < 1.",
        default=None,
        usual="0; 0.01 where `accuracy` is given",
    ),
    "record": Key(
        partial(choice, known=RECORDS),
        "In what the kept points of a trace are evenly spaced: time, distance slid, or the "
        "logarithm of time.",
        default=USUAL.record,
    ),
    "trace": Key(
        partial(integer, least=1),
        "Keep every step whose number is a multiple of this one, instead of `samples` points and "
        "without `record`.",
        "Doubled, a trace has half as many points.",
        default=None,
    ),
}


def read_numerics(where: str, given: Mapping[str, Any]) -> Numerics:
    """Return the numerics of the checked values of a table of this name. Raises UserError."""
    values = filled(where, given, NUMERICS)
    if "trace" in given and "record" in given:
        raise UserError(
            f"{where}.trace = {given['trace']}: keeps every so many steps; leave record out"
        )
    if values["horizon"] is None:
        fine = values["accuracy"] is not None and values["accuracy"] < LONG_BELOW
        values["horizon"] = LONG_HORIZON if fine else USUAL.horizon
    if values["negligible"] is None:
        values["negligible"] = USUAL.negligible if values["accuracy"] is None else NEGLIGIBLE
    found = Numerics(curve_samples=values.pop("samples"), **values)
    if found.accuracy and found.scheme != USUAL.scheme and not found.steps_per_spacing:
        raise UserError(
            f"{where}.scheme = {found.scheme!r}: where the accuracy chooses the steps it takes "
            f"{USUAL.scheme}, never dearer; leave scheme out or give steps_per_spacing too"
        )
    return found
