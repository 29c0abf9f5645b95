"""Workers with other versions than the driver are refused with a table."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.system import packages
from elastomer_friction.workflow.system.packages import own_versions, require


def test_equal_versions_of_packages_python_and_sources_are_accepted():
    require(own_versions())
    assert set(own_versions()) == {*packages.WORKER_PACKAGES, "python", "our sources"}
    assert all("not installed" not in value for value in own_versions().values())


def test_an_edit_changes_the_version(tmp_path, monkeypatch):
    for name in packages.SOURCE_FOLDERS:
        (tmp_path / name / "room").mkdir(parents=True)
        (tmp_path / name / "room" / "a.py").write_text("x = 1\n")
    monkeypatch.setattr(packages, "PROGRAM_ROOT", tmp_path)
    monkeypatch.setattr(packages, "our_sources", packages.our_sources.__wrapped__)
    before = own_versions.__wrapped__()
    (tmp_path / "kernels" / "room" / "a.py").write_text("x = 2\n")
    after = own_versions.__wrapped__()
    assert {name for name in before if before[name] != after[name]} == {"our sources"}


@pytest.mark.parametrize("name", ["numba", "our sources"])
def test_a_worker_that_differs_refuses_with_a_table(name):
    with pytest.raises(UserError) as error:
        require(own_versions() | {name: "0.1"})
    (line,) = str(error.value).splitlines()[2:]
    assert name in line
    assert line.endswith("0.1")
    assert own_versions()[name] in line
