"""A skipped test that is not on the list of allowed skips is a failure."""

import pytest

from tests.support.python import ROOT, python

TESTS = """
import pytest
def test_known():
    pytest.skip("no moon: it is day")
def test_stranger():
    pytest.skip("no sun")
"""
FILE = """
import pytest
pytest.importorskip("no_such_package_as_this")
"""


def tried(folder, skips, *options):
    """Write tests and a list of skips to a folder; return exit status and output of the tests."""
    (folder / "test_some.py").write_text(TESTS)
    (folder / "pytest.ini").write_text("[pytest]\n")
    (folder / "skips.txt").write_text(skips)
    plugins = ["-p", "no:cacheprovider", "-p", "tests.support.skips"]
    words = ["-m", "pytest", "-q", *plugins, *options]
    done = python(*words, cwd=folder, SKIPS="skips.txt", PYTHONPATH=str(ROOT))
    return done.returncode, done.stdout


@pytest.mark.parametrize("options", [("-n", "0"), ("-n", "1")], ids=["alone", "spread"])
def test_a_skip_that_is_not_on_the_list_is_a_failure(tmp_path, options):
    (tmp_path / "test_file.py").write_text(FILE)
    status, out = tried(tmp_path, "# a list\ntest_some.py: no moon\n", *options)
    assert status == 1
    strangers = [line for line in out.splitlines() if line.startswith("skipped, but not on")]
    assert len(strangers) == 2
    assert "test_file.py: could not import 'no_such_package_as_this'" in out
    assert strangers[-1].endswith("test_some.py::test_stranger: no sun")
