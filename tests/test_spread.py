"""Tests of a file share their fixtures: they are spread over processes file by file."""

import pytest

from tests.conftest import ByFile, group_of


@pytest.mark.parametrize("name", ["a::b@c", "[]"])
def test_the_tests_of_a_file_are_of_one_group(request, name):
    assert group_of(request.node.nodeid) == "tests/test_spread.py"
    assert group_of(f"tests/test_spread.py::test[{name}]") == "tests/test_spread.py"


def test_xdist_asks_for_the_group():
    assert ByFile._split_scope(None, "tests/test_a.py::test_it") == "tests/test_a.py"
