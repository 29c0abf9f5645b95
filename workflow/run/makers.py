"""One kind of records, where a user wants no other: the same packages on the same processor."""

from ..errors import UserError
from ..system import Maker


def require_one(makers: set[Maker], asked: bool) -> None:
    """Raise UserError where records are of several makers, if one alone is asked for."""
    if asked and len(makers) > 1:
        said = "; ".join(f"{maker.versions} on {maker.processor}" for maker in sorted(makers))
        raise UserError(
            f"--one-kind: records of {len(makers)} kinds would be mixed: {said}; compute in "
            "another folder (--out), or leave the option out"
        )
