"""How problems are discretised: the tables [numerics] and [compare.NAME]."""

import re
from functools import partial
from typing import Any, NamedTuple

from kernels import SCHEMES
from workflow.errors import UserError
from workflow.study.checks import Key, as_table, choice, integer, read_table, within

LONG_HORIZON = 6.0  # below 1 %: beyond 4 expected times b changes by 0.5 %, at worst by 5 %
LONG_BELOW = 0.01
# Beyond the one nothing is in reach, beyond the other no law holds.
ACCURACY = partial(within, least=1e-4, most=0.3, hint=" (0.01 is 1 %)")
AUTO = "auto"


class Numerics(NamedTuple):
    """How problems are discretised; ``steps_per_spacing = None`` stands for "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    curve_samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # wanted relative error of what is asked for
    max_realizations: int = 10_000  # per point, on the way to the accuracy


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
}


def read_variants(tables: dict[str, Any]) -> dict[str, Numerics]:
    """Return label -> numerics of the study ("") and of its comparisons. Raises UserError."""
    own = as_table("numerics", tables.get("numerics", {}))
    variants = {"": _numerics("numerics", own)}
    for label, extra in as_table("compare", tables.get("compare", {})).items():
        where = f"compare.{label}"
        if not re.fullmatch(r"[A-Za-z]\w*", label):
            raise UserError(f'compare."{label}": name it by letters, digits and underscores')
        variants[label] = _numerics(where, {**own, **as_table(where, extra)})
    return variants


def _numerics(where: str, table: dict[str, Any]) -> Numerics:
    values = read_table(where, table, NUMERICS)
    if values["horizon"] is None:
        fine = values["accuracy"] is not None and values["accuracy"] < LONG_BELOW
        values["horizon"] = LONG_HORIZON if fine else USUAL.horizon
    found = Numerics(curve_samples=values.pop("samples"), **values)
    if found.accuracy and found.scheme != USUAL.scheme and not found.steps_per_spacing:
        raise UserError(
            f"{where}.scheme = {found.scheme!r}: where the accuracy chooses the steps it takes "
            f"{USUAL.scheme}, never dearer; leave scheme out or give steps_per_spacing too"
        )
    return found
