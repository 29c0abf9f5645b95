"""One finished run of the small study, and a client of the cluster of all tests."""

import shutil
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from distributed import Client

from tests.support.results import FIGURE
from tests.support.runs import Run, run
from tests.support.small import write_study

# A measured study that is small enough to run whole: powers of a number.
POWERS_STUDY = """
[study]
title = "Powers of two"
seed = 5
[measure]
powers = 3
base = 2.0
[scales.smoke.measure]
powers = 1
"""
POWERS_MEASURE = """
from functools import partial
import pandas as pd
import xarray as xr
from elastomer_friction.workflow.study import Key, integer, positive
from .helper import power

SETTINGS = {"powers": Key(partial(integer, least=1)), "base": Key(positive)}

def outline(settings):
    return [f"powers      {settings['powers']}"], 0.5 * settings["powers"]

def measure(settings, seed, advance):
    found = []
    for exponent in range(settings["powers"]):
        found.append(power(settings["base"], exponent))
        advance(0.5)
    return {"": xr.Dataset({"found": ("n", found)}), "seed": xr.Dataset({"seed": seed})}

def summary(groups):
    return [f"largest {float(groups[''].found.max()):g}"]

def table(groups):
    return pd.DataFrame({"found": groups[""].found.values})
"""
POWERS_FIGURE = """
from matplotlib import pyplot as plt
from .helper import power

def draw(groups):
    figure, ax = plt.subplots()
    ax.plot(groups[""].found)
    return figure
"""


@pytest.fixture
def clock(monkeypatch) -> list[float]:
    """Return the time, which passes when it is told to: clock[0] += seconds.

    In the thread of the tests alone: what the cluster of all tests puts off meanwhile would else
    wait until the machine has been on for as long.
    """
    now = [1e5]  # as long as the machine has been on: no duration may depend on it
    here, monotonic = threading.get_ident(), time.monotonic
    monkeypatch.setattr(
        time, "monotonic", lambda: now[0] if threading.get_ident() == here else monotonic()
    )
    return now


@pytest.fixture
def study(tmp_path) -> str:
    """Return the path of the small study."""
    return write_study(tmp_path)


@pytest.fixture
def powers(tmp_path, monkeypatch) -> Path:
    """Return the folder of a measured study, under studies/ of the working folder."""
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "studies" / "powers"
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(POWERS_STUDY)
    (folder / "measure.py").write_text(POWERS_MEASURE)
    (folder / "figure.py").write_text(POWERS_FIGURE)
    (folder / "helper.py").write_text("def power(base, n):\n    return base**n\n")
    return folder


@pytest.fixture(scope="session")
def client(local) -> Iterator[Client]:
    """Return a client of the scheduler, in its thread: a new one must start within ten seconds."""
    with Client(local) as client:
        yield client


@pytest.fixture(scope="session")
def finished(tmp_path_factory) -> Run:
    """Return the small study run in this process. Leave its folder as it is."""
    return run(tmp_path_factory.mktemp("finished"))


@pytest.fixture
def shown(finished, tmp_path) -> Path:
    """Return a folder with the small study, its figure script and its finished result."""
    write_study(tmp_path)
    (tmp_path / "figure.py").write_text(FIGURE)
    shutil.copy(finished.path, tmp_path / "small.nc")
    return tmp_path
