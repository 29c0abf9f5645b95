"""The table [numerics]: discretisation of the problems and requested accuracy."""

from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

from ...kernels import SCHEMES
from ..ground import UserError
from .settings import OPTIONAL, Key, choice, filled, integer, within

LONG_HORIZON = 6.0  # expected relaxation times; beyond 4, b changes by 0.5 %, at worst by 5 %
LONG_HORIZON_ACCURACY = 0.01  # the long horizon is used for smaller accuracies
# Below 1e-4 no accuracy can be reached; above 0.3 the error laws do not hold.
ACCURACY = partial(within, least=1e-4, most=0.3, hint=" (0.01 is 1 %)")
AUTO = "auto"
NEGLIGIBLE_SHARE = 0.01  # default share of the jump if an accuracy is requested
RECORDS = ("time", "distance", "log")


class Numerics(NamedTuple):
    """Discretisation of the problems; ``steps_per_spacing = None`` means "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    curve_samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # requested relative error
    max_realizations: int = 10_000  # limit per point, with accuracy
    negligible: float = 0.0  # share of the jump; a smaller relaxation needs no rate
    record: str = "time"  # quantity in which the samples of a trace are evenly spaced
    trace: int | None = None  # steps between the samples, in place of record

    @property
    def refines(self) -> bool:
        """Return whether contact edges of steady sliding are located between the samples.

        This is done only if "auto" chooses the steps. A given number of steps is used as it is,
        and the result marks unresolved contacts.
        """
        return self.steps_per_spacing is None


def _steps(key: str, value: object) -> int | None:
    return None if value == AUTO else integer(key, value, 1)


DEFAULTS = Numerics()
NUMERICS = {
    "scheme": Key(
        partial(choice, known=SCHEMES),
        "The time-stepping scheme. `exponential` is of second order; a free element decays by "
        "exp(−Δt/τ) per step. `implicit-euler` is of first order; it decays by 1/(1 + Δt/τ). "
        "With a given `steps_per_spacing` its µ₁, µ₂ and Δµ₀ are those of the steps.",
        default=DEFAULTS.scheme,
    ),
    "steps_per_spacing": OPTIONAL(
        _steps,
        'The number m of time steps, and of samples of the line, per spacing Δx. With `"auto"` '
        "each point takes the smallest m that keeps the discretisation error of the requested "
        "quantities below 2 %, if possible (maps: in 2 GB), and resolves steady friction and jump "
        "to 10⁻⁵; measured lines have m = 4, branches and programmes m = 8. A number is used at "
        "every point; `resolution_status` marks contacts that it does not resolve.",
        "Doubled, the error of µ₁ falls to about a third, those of Δµ₀ and b to about half; "
        "steady states take twice the time, relaxation up to four times.",
        values='a whole number, at least 1, or `"auto"`',
        usual='`"auto"`',
        schema={"anyOf": [{"const": AUTO}, {"type": "integer", "minimum": 1}]},
    ),
    "samples": Key(
        partial(integer, least=8, most=10_000),
        "The number of stored points of each relaxation curve or trace.",
        "Doubled, the file is larger.",
        default=DEFAULTS.curve_samples,
        usual="64; 200 in `scene.run`",
    ),
    "horizon": OPTIONAL(
        partial(within, least=1.0, most=100.0),
        "The duration of the marched relaxation, in expected relaxation times.",
        "Doubled, the march takes twice as long; beyond 4 the rate changes by about 0.5 %.",
        usual="4; 6 if `accuracy` is below 1 %",
    ),
    "accuracy": OPTIONAL(
        ACCURACY,
        "The requested relative error of µ₁, Δµ₀ and b: standard error plus bound of the "
        "discretisation error. The program chooses m and the number of lines.",
        "Doubled, a quarter of the lines and often fewer steps suffice.",
    ),
    "max_realizations": Key(
        partial(integer, least=1),
        "With `accuracy`, the maximum number of lines of a point. The result marks points that "
        "miss the accuracy.",
        "Doubled, hard points take twice the time for an error smaller by √2.",
        default=DEFAULTS.max_realizations,
    ),
    "negligible": OPTIONAL(
        partial(within, least=0.0, most=1.0),
        "A share of the jump Δµ₀. If the relaxation is significantly smaller, no line is added to "
        "determine b (`fit_status` is `negligible`).",
        "Doubled, b remains undetermined at more points with x < 1.",
        usual="0; 0.01 if `accuracy` is given",
    ),
    "record": Key(
        partial(choice, known=RECORDS),
        "The quantity in which the stored points of a trace are evenly spaced: time, distance "
        "slid, or the logarithm of time.",
        default=DEFAULTS.record,
    ),
    "trace": OPTIONAL(
        partial(integer, least=1),
        "The number of steps between two stored points of a trace, in place of `samples` and "
        "`record`; of the steps of the line itself if a drive pulls a single line.",
        "Doubled, a trace has half as many points.",
    ),
}


def read_numerics(where: str, given: Mapping[str, Any]) -> Numerics:
    """Return the numerics of the checked values of the table named ``where``. Raises UserError."""
    values = filled(where, given, NUMERICS)
    if "trace" in given and "record" in given:
        raise UserError(
            f"{where}.trace = {given['trace']}: sets the spacing of the points; omit record"
        )
    if values["horizon"] is None:
        accuracy = values["accuracy"]
        fine = accuracy is not None and accuracy < LONG_HORIZON_ACCURACY
        values["horizon"] = LONG_HORIZON if fine else DEFAULTS.horizon
    if values["negligible"] is None:
        share = DEFAULTS.negligible if values["accuracy"] is None else NEGLIGIBLE_SHARE
        values["negligible"] = share
    numerics = Numerics(curve_samples=values.pop("samples"), **values)
    if numerics.accuracy and numerics.scheme != DEFAULTS.scheme and not numerics.steps_per_spacing:
        raise UserError(
            f"{where}.scheme = {numerics.scheme!r}: an accuracy chooses the steps for the scheme "
            f"{DEFAULTS.scheme}, which costs less; omit scheme or give steps_per_spacing"
        )
    return numerics
