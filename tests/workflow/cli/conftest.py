"""The small study as a file, for commands that name it."""

import pytest

from tests.support.small import write_study


@pytest.fixture
def study(tmp_path):
    """Return the path of the small study."""
    return write_study(tmp_path)
