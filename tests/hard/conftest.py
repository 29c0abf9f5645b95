"""A store with three sound shards, to be spoilt."""

import os

import pytest

from tests.support.faults import fill
from workflow.store.store import Store


@pytest.fixture
def instant(monkeypatch):
    """Do not wait for the disk."""
    monkeypatch.setattr(os, "fsync", lambda _: None)


@pytest.fixture
def sound(tmp_path, instant):
    """Return the folder of a store with three sound shards."""
    folder = tmp_path / "sound"
    folder.mkdir()
    fill(Store(folder))
    return folder
