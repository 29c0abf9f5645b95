"""Sweeps over many cases: a thin slice in `make test`, all cases in `make test-all`."""

from collections.abc import Sequence
from typing import Any

import pytest
from hypothesis import settings

USUAL = 100  # examples that hypothesis tries by default


def sweep(name: str, thin: Any, whole: Any) -> pytest.MarkDecorator:
    """Parametrize a test by a thin slice of a sweep, and by the whole sweep as exhaustive."""
    return pytest.mark.parametrize(
        name,
        [
            pytest.param(thin, id="thin"),
            pytest.param(whole, id="whole", marks=pytest.mark.exhaustive),
        ],
    )


def mostly_exhaustive(names: str, thin: Sequence, rest: Sequence) -> pytest.MarkDecorator:
    """Parametrize a test by some cases, and by further ones that are marked exhaustive."""
    more = [pytest.param(*_tuple(case), marks=pytest.mark.exhaustive) for case in rest]
    return pytest.mark.parametrize(names, [*thin, *more])


def _tuple(case: Any) -> tuple:
    return case if isinstance(case, tuple) else (case,)


def examples(usual: int) -> int:
    """Return the number of examples of a property test, scaled by --hypothesis-profile."""
    return usual * settings().max_examples // USUAL
