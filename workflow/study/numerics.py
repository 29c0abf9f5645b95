"""How problems are discretised: the tables [numerics] and [compare.NAME]."""

import re
from dataclasses import dataclass
from functools import partial
from typing import Any

from kernels import SCHEMES
from workflow.errors import UserError
from workflow.study.checks import Key, as_table, choice, integer, read_table, within

LONG_HORIZON = 6.0  # below 1 %: beyond 4 expected times b changes by 0.5 %, at worst by 5 %
LONG_BELOW = 0.01
ACCURACIES = (1e-4, 0.3)  # beyond the one nothing is in reach, beyond the other no law holds
AUTO = "auto"


@dataclass(frozen=True)
class Numerics:
    """How problems are discretised; ``steps_per_spacing = None`` stands for "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    curve_samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # wanted relative error of what is asked for
    max_realizations: int = 10_000  # per point, on the way to the accuracy


def _steps(key: str, value: object) -> int | None:
    return None if value == AUTO else integer(key, value, 1)


NUMERICS = {
    "scheme": Key(partial(choice, known=SCHEMES), Numerics.scheme),
    "steps_per_spacing": Key(_steps, None),
    "samples": Key(partial(integer, least=8, most=10_000), Numerics.curve_samples),
    "horizon": Key(partial(within, least=1.0, most=100.0), None),
    "accuracy": Key(
        partial(within, least=ACCURACIES[0], most=ACCURACIES[1], hint=" (0.01 is 1 %)"), None
    ),
    "max_realizations": Key(partial(integer, least=1), Numerics.max_realizations),
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
        values["horizon"] = LONG_HORIZON if fine else Numerics.horizon
    found = Numerics(curve_samples=values.pop("samples"), **values)
    if found.accuracy and found.scheme != Numerics.scheme and not found.steps_per_spacing:
        raise UserError(
            f"{where}.scheme = {found.scheme!r}: where the accuracy chooses the steps it takes "
            f"{Numerics.scheme}, never dearer; leave scheme out or give steps_per_spacing too"
        )
    return found
