"""How problems are discretised: the tables [numerics] and [compare.NAME]."""

import re
from dataclasses import dataclass

from kernels import SCHEMES
from workflow.errors import UserError
from workflow.study.checks import as_table, check_keys, choice, integer, number


@dataclass(frozen=True)
class Numerics:
    """How problems are discretised; ``steps_per_spacing = None`` stands for "auto"."""

    scheme: str = "exponential"
    steps_per_spacing: int | None = None
    samples: int = 64
    horizon: float = 4.0
    accuracy: float | None = None  # wanted relative error of what is asked for
    max_realizations: int = 10_000  # per point, on the way to the accuracy


NUMERICS = (
    *("scheme", "steps_per_spacing", "samples", "horizon"),
    *("accuracy", "max_realizations"),
)

LONG_HORIZON = 6.0  # below 1 %: beyond 4 expected times b changes by 0.5 %, at worst by 5 %
ACCURACIES = (1e-4, 0.3)  # beyond the one nothing is in reach, beyond the other no law holds


def read_variants(tables: dict) -> dict[str, Numerics]:
    """Return label -> numerics of the study ("") and of its comparisons. Raises UserError."""
    own = tables.get("numerics", {})
    variants = {"": _numerics("numerics", own)}
    for label, extra in as_table("compare", tables.get("compare", {})).items():
        where = f"compare.{label}"
        if not re.fullmatch(r"[A-Za-z]\w*", label):
            raise UserError(f'compare."{label}": name it by letters, digits and underscores')
        check_keys(f"{where}.", as_table(where, extra), NUMERICS)
        variants[label] = _numerics(where, {**own, **extra})
    return variants


def _numerics(where: str, table: dict) -> Numerics:
    default = Numerics()
    steps = table.get("steps_per_spacing", "auto")
    accuracy = _accuracy(where, table)
    usual = LONG_HORIZON if accuracy and accuracy < 0.01 else default.horizon
    horizon = number(f"{where}.horizon", table.get("horizon", usual))
    if not 1.0 <= horizon <= 100.0:
        raise UserError(f"{where}.horizon = {horizon!r}: must lie between 1 and 100")
    most = table.get("max_realizations", default.max_realizations)
    found = Numerics(
        scheme=choice(f"{where}.scheme", table.get("scheme", default.scheme), tuple(SCHEMES)),
        steps_per_spacing=(
            None if steps == "auto" else integer(f"{where}.steps_per_spacing", steps, 1)
        ),
        samples=integer(f"{where}.samples", table.get("samples", default.samples), 8, 10_000),
        horizon=horizon,
        accuracy=accuracy,
        max_realizations=integer(f"{where}.max_realizations", most, 1),
    )
    if found.accuracy and found.scheme != default.scheme and not found.steps_per_spacing:
        raise UserError(
            f"{where}.scheme = {found.scheme!r}: where the accuracy chooses the steps it takes "
            f"{default.scheme}, never dearer; leave scheme out or give steps_per_spacing too"
        )
    return found


def _accuracy(where: str, table: dict) -> float | None:
    if "accuracy" not in table:
        return None
    key = f"{where}.accuracy"
    value = number(key, table["accuracy"])
    least, most = ACCURACIES
    if not least <= value <= most:
        raise UserError(f"{key} = {value!r}: must lie between {least:g} and {most:g} (0.01 is 1 %)")
    return value
