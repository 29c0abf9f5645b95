"""What this process runs: versions of packages, and the processor."""

import platform
from importlib.metadata import version
from pathlib import Path

from elastomer_friction.workflow.system.packages import (
    PACKAGES,
    package_versions,
    processor,
    this_maker,
    version_of,
)


def test_versions_of_all_packages_are_told():
    found = package_versions().split(", ")
    assert found == [f"{name} {version(name)}" for name in PACKAGES]


def test_what_numbers_depend_on_is_told_of_every_process_that_computes():
    versions = this_maker().versions
    assert versions.startswith(f"python {platform.python_version()}, ")
    for name in ("numpy", "numba", "llvmlite"):
        assert f"{name} {version(name)}" in versions.split(", ")
    assert this_maker().processor == processor()
    assert {"numpy", "numba", "scipy", "dask", "distributed", "xarray", "netCDF4"} == set(PACKAGES)


def test_a_package_that_is_not_there_is_said_to_be_missing():
    assert version_of("no-such-package-as-this") == "not installed"


def test_the_processor_is_named_wherever_it_can_be_asked(monkeypatch):
    assert processor()

    def refuse(*_, **__):
        raise OSError

    monkeypatch.setattr(Path, "read_text", refuse)
    assert processor() == (platform.processor() or platform.machine())
