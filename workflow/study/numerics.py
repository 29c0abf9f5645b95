"""How problems are discretised: the table [numerics]."""

from functools import partial
from typing import Any, NamedTuple

from ...kernels import SCHEMES
from ..errors import UserError
from .settings import Key, choice, integer, read_table, within

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
        """Return whether narrow contacts are read from finer samples than the steps are.

        Where "auto" chooses the steps. Steps that are given are taken as they are, everywhere, and
        what they do not resolve is marked in the result.
        """
        return self.steps_per_spacing is None


def _steps(key: str, value: object) -> int | None:
    return None if value == AUTO else integer(key, value, 1)


USUAL = Numerics()
NUMERICS = {
    "scheme": Key(partial(choice, known=SCHEMES), USUAL.scheme),
    "steps_per_spacing": Key(_steps, None),
    "samples": Key(partial(integer, least=8, most=10_000), USUAL.curve_samples),
    "horizon": Key(partial(within, least=1.0, most=100.0), None),
    "accuracy": Key(ACCURACY, None),
    "max_realizations": Key(partial(integer, least=1), USUAL.max_realizations),
    "negligible": Key(partial(within, least=0.0, most=1.0), None),
    "record": Key(partial(choice, known=RECORDS), USUAL.record),
    "trace": Key(partial(integer, least=1), None),
}


def read_numerics(where: str, table: dict[str, Any]) -> Numerics:
    """Return the numerics of a table of this name. Raises UserError."""
    values = read_table(where, table, NUMERICS)
    if "trace" in table and "record" in table:
        raise UserError(
            f"{where}.trace = {table['trace']}: keeps every so many steps; leave record out"
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
