"""The stored speed of the machine: kept, read, measured anew when damaged, never in the way."""

import json

import pytest

from workflow.plan.cost import TYPICAL, machine
from workflow.plan.cost.machine import this_machine, timings_file

TEXT = json.dumps({"machine": "M", "date": "2020-01-01", "timings": TYPICAL._asdict()})


@pytest.fixture
def measured(tmp_path, monkeypatch):
    """Keep timings in a folder of the test; return the calls of the measurement."""
    calls = []

    def measure():
        calls.append(1)
        return TEXT

    monkeypatch.setattr(machine, "timings_file", timings_file)  # not that of all tests
    monkeypatch.setattr(machine, "_measured", measure)
    monkeypatch.setattr(machine, "load_kernels", lambda *_: None)
    monkeypatch.setattr("kernels.cache.FOLDER", str(tmp_path / "cache"))
    return calls


def test_it_is_measured_once_and_kept(measured):
    first, second = this_machine(), this_machine()
    assert len(measured) == 1
    assert first == second == (TYPICAL, "M, 2020-01-01")
    assert timings_file().read_text() == TEXT


@pytest.mark.parametrize("name", ["source_hash", "processor"])
def test_other_kernels_and_another_processor_have_rates_of_their_own(measured, monkeypatch, name):
    this_machine()
    monkeypatch.setattr(machine, name, lambda: "another")
    this_machine()
    assert len(measured) == 2


DAMAGED = [
    *("", "{", "[]", "null", "\xff", TEXT[: len(TEXT) // 2]),
    TEXT.replace("draw", "drew"),
    TEXT.replace("1.2e-05", "-1.2e-05"),
    TEXT.replace("1.2e-05", "NaN"),
    TEXT.replace("1.2e-05", '"fast"'),
    TEXT.replace("1.2e-05, ", "", 1),
]


@pytest.mark.parametrize("text", DAMAGED)
def test_a_damaged_file_is_measured_anew(measured, text):
    assert text != TEXT
    this_machine()
    timings_file().write_text(text, encoding="latin-1")
    assert this_machine().timings == TYPICAL
    assert len(measured) == 2
    assert timings_file().read_text() == TEXT


def test_a_folder_that_cannot_be_written_is_noted(measured, tmp_path):
    (tmp_path / "cache").write_text("in the way")
    found = this_machine()
    assert found.timings == TYPICAL
    assert "not kept" in found.note


def test_a_machine_that_cannot_be_timed_is_noted(measured, monkeypatch):
    monkeypatch.setattr(machine, "_measured", lambda: "")
    found = this_machine()
    assert found.timings == TYPICAL
    assert "another machine" in found.note
    assert not timings_file().exists()
