"""The rooms of the workflow: entered by their public names, light to import, of a size to know."""

import ast
from pathlib import Path

import pytest

from elastomer_friction import workflow
from tests.support.imports import module_of
from tests.support.python import printed

FOLDER = Path(workflow.__file__).resolve().parent
ROOMS = sorted(  # "study", and "study.surfaces" within it
    ".".join(path.parent.relative_to(FOLDER).parts) for path in FOLDER.glob("*/**/__init__.py")
)
HEAVY = ("distributed", "dask", "xarray", "netCDF4", "pandas", "matplotlib", "scipy")
NAME = "elastomer_friction.workflow"


def folder_of(room):
    """Return the folder of a room."""
    return FOLDER.joinpath(*room.split("."))


def imports(path):
    """Return the modules that a file imports names from."""
    nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    return {module_of(node, path) for node in nodes if isinstance(node, ast.ImportFrom)}


def test_rooms_are_entered_by_their_public_names_alone():
    deep = set()
    for path in FOLDER.parent.glob("[ksw]*/**/*.py"):
        others = tuple(
            f"{NAME}.{room}." for room in ROOMS if not path.is_relative_to(folder_of(room))
        )
        deep |= {f"{path.name}: {name}" for name in imports(path) if name.startswith(others)}
    assert not deep


@pytest.mark.parametrize("room", ROOMS)
def test_every_public_name_is_there_and_documented(room):
    package = __import__(f"{NAME}.{room}", fromlist=["room"])
    assert len(package.__doc__.strip().splitlines()) == 3  # a line, an empty one, a line
    for name in package.__all__:
        value = getattr(package, name)
        assert not callable(value) or value.__doc__, name
    with pytest.raises(AttributeError, match=f"'{NAME}.{room}' has no attribute 'nothing'"):
        _ = package.nothing


def test_no_public_name_is_that_of_a_file_of_its_room():
    """Or the file, once imported, would hide the name."""
    for room in ROOMS:
        files = {path.stem for path in folder_of(room).glob("*.py")}
        assert files.isdisjoint(__import__(f"{NAME}.{room}", fromlist=["room"]).__all__)


def test_importing_rooms_loads_nothing_heavy():
    names = ", ".join(f"{NAME}.{room}" for room in ROOMS)
    code = f"import {names}, sys; print([m for m in {HEAVY!r} if m in sys.modules])"
    assert printed("-c", code, cwd=FOLDER.parent) == "[]\n"
