"""The study that a module is about, run at smoke scale once, and drawn."""

import pytest

from tests.support.studies import run


@pytest.fixture(scope="module")
def result(request, tmp_path_factory):
    """Return the groups of the study that the module names, with its settings, in ``STUDY``."""
    name, *settings = request.module.STUDY
    return run(tmp_path_factory.mktemp(name), name, *settings)


@pytest.fixture(scope="module")
def groups(result):
    """Return the groups of the study, without the axes of length 1."""
    return {name: data.squeeze() for name, data in result.items()}
