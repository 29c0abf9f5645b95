"""The stored pace of the machine: kept, corrected by runs, measured anew when damaged."""

import json

import pytest

from elastomer_friction.workflow.plan.cost import machine
from elastomer_friction.workflow.plan.cost.machine import (
    TYPICAL,
    Pace,
    known_machine,
    label,
    learn,
    pace_file,
    this_machine,
)
from elastomer_friction.workflow.plan.cost.work import PARTS, PLAIN

MEASURED = dict.fromkeys(PARTS, (1.25, 1.1))
TEXT = json.dumps({"machine": "M", "date": "2020-01-01", "measured": MEASURED, "learned": {}})
PACE = Pace(MEASURED, {})


@pytest.fixture
def measured(tmp_path, monkeypatch):
    """Keep the pace in a folder of the test; return the calls of the measurement."""
    calls = []

    def measure():
        calls.append(1)
        return TEXT

    monkeypatch.setattr(machine, "pace_file", pace_file)  # not that of all tests
    monkeypatch.setattr(machine, "_measured", measure)
    monkeypatch.setattr(machine, "load_kernels", lambda *_: None)
    monkeypatch.setattr("elastomer_friction.kernels.compile.cache.FOLDER", str(tmp_path / "cache"))
    return calls


def test_it_is_measured_once_and_kept(measured):
    assert known_machine() is None
    first, second = this_machine(), this_machine()
    assert known_machine() == first
    assert len(measured) == 1
    assert first == second == (PACE, "M, 2020-01-01")
    assert json.loads(pace_file().read_text()) == json.loads(TEXT)


@pytest.mark.parametrize("name", ["source_hash", "processor"])
def test_other_kernels_and_another_processor_have_rates_of_their_own(measured, monkeypatch, name):
    this_machine()
    monkeypatch.setattr(machine, name, lambda: "another")
    this_machine()
    assert len(measured) == 2


DAMAGED = [
    *("", "{", "[]", "null", "\xff", TEXT[: len(TEXT) // 2]),
    TEXT.replace("jump", "leap"),
    TEXT.replace("1.25", "-1.25"),
    TEXT.replace("1.25", "NaN"),
    TEXT.replace("1.25", '"fast"'),
    TEXT.replace("1.25, ", "", 1),
    TEXT.replace('"learned": {}', '"learned": {"plain steady": [1.0, 0.0, 99999.0]}'),
    TEXT.replace('"learned": {}', '"learned": {"plain steady": [NaN, 0.0, 0.0]}'),
]


@pytest.mark.parametrize("text", DAMAGED)
def test_a_damaged_file_is_measured_anew(measured, text):
    assert text != TEXT
    this_machine()
    pace_file().write_text(text, encoding="latin-1")
    assert this_machine().pace == PACE
    assert len(measured) == 2
    assert json.loads(pace_file().read_text()) == json.loads(TEXT)


def test_a_folder_that_cannot_be_written_is_noted(measured, tmp_path):
    (tmp_path / "cache").write_text("in the way")
    found = this_machine()
    assert found.pace == PACE
    assert "not kept" in found.note


def test_a_machine_that_cannot_be_timed_is_noted(measured, monkeypatch):
    monkeypatch.setattr(machine, "_measured", lambda: "")
    found = this_machine()
    assert found.pace == TYPICAL
    assert "another machine" in found.note
    assert not pace_file().exists()


def test_what_runs_took_is_kept_and_told(measured):
    learn({(PLAIN, "steady"): 60.0}, {(PLAIN, "steady"): 20.0})
    assert not measured  # nothing to correct yet
    before = this_machine().pace
    learn({(PLAIN, "steady"): 60.0, (PLAIN, "jump"): 1e-3}, {(PLAIN, "steady"): 20.0})
    after = this_machine()
    assert len(measured) == 1
    assert after.note == "M, 2020-01-01, and in 0.017 core-hours of runs"
    rates = [pace.rate(PLAIN, "steady").factor for pace in (before, after.pace)]
    assert rates[0] == pytest.approx(1.25)
    assert 2.5 < rates[1] < 3.0
    assert after.pace.learned[label(PLAIN, "jump")].seconds == 0.0
