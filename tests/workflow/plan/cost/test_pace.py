"""The pace of a machine: measured, kept, and learned from runs by kind of work."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.plan.cost import machine
from elastomer_friction.workflow.plan.cost.machine import (
    LAWS,
    LEAST_SECONDS,
    MOST_SECONDS,
    TYPICAL,
    Learned,
    Pace,
    known_machine,
    label,
    learn,
    pace_file,
    prediction,
    this_machine,
)
from elastomer_friction.workflow.plan.cost.work import BRANCHES, PARTS, PLAIN
from elastomer_friction.workflow.plan.plan import make_plan
from tests.support.small import small_study

MEASURED_FACTORS = dict.fromkeys(PARTS, (1.25, 1.1))
TEXT = json.dumps(
    {"machine": "M", "date": "2020-01-01", "measured": MEASURED_FACTORS, "learned": {}}
)
PACE = Pace(MEASURED_FACTORS, {})


@pytest.fixture
def timed(tmp_path, monkeypatch):
    """Keep the pace in a folder of the test; return the calls of the measurement."""
    calls = []

    def measure():
        calls.append(1)
        return TEXT

    monkeypatch.setattr(machine, "pace_file", pace_file)  # not that of all tests
    monkeypatch.setattr(machine, "_measured", measure)
    monkeypatch.setattr(machine, "load_kernels", lambda *_: None)
    monkeypatch.setattr(
        "elastomer_friction.kernels.compile.cache.CACHE_FOLDER", str(tmp_path / "cache")
    )
    return calls


def test_it_is_measured_once_and_kept(timed):
    assert known_machine() is None
    first, second = this_machine(), this_machine()
    assert known_machine() == first
    assert len(timed) == 1
    assert first == second == (PACE, "M, 2020-01-01")
    assert json.loads(pace_file().read_text()) == json.loads(TEXT)


@pytest.mark.parametrize("name", ["source_hash", "processor"])
def test_other_kernels_and_another_processor_have_rates_of_their_own(timed, monkeypatch, name):
    this_machine()
    monkeypatch.setattr(machine, name, lambda: "another")
    this_machine()
    assert len(timed) == 2


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
def test_a_damaged_file_is_measured_anew(timed, text):
    assert text != TEXT
    this_machine()
    pace_file().write_text(text, encoding="latin-1")
    assert this_machine().pace == PACE
    assert len(timed) == 2
    assert json.loads(pace_file().read_text()) == json.loads(TEXT)


def test_a_folder_that_cannot_be_written_is_noted(timed, tmp_path):
    (tmp_path / "cache").write_text("in the way")
    found = this_machine()
    assert found.pace == PACE
    assert "not kept" in found.note


def test_a_machine_that_cannot_be_timed_is_noted(timed, monkeypatch):
    monkeypatch.setattr(machine, "_measured", lambda: "")
    found = this_machine()
    assert found.pace == TYPICAL
    assert "another machine" in found.note
    assert not pace_file().exists()


def test_what_runs_took_is_kept_and_told(timed):
    learn({(PLAIN, "steady"): 1200.0}, {(PLAIN, "steady"): 400.0})
    assert not timed  # nothing to correct yet
    before = this_machine().pace
    learn({(PLAIN, "steady"): 1200.0, (PLAIN, "jump"): 1e-3}, {(PLAIN, "steady"): 400.0})
    after = this_machine()
    assert len(timed) == 1
    assert after.note == "M, 2020-01-01, and in 0.33 core-hours of runs"
    rates = [pace.rate(PLAIN, "steady").factor for pace in (before, after.pace)]
    assert rates[0] == pytest.approx(1.25)
    assert 2.5 < rates[1] < 3.0
    assert after.pace.learned[label(PLAIN, "jump")].seconds == 0.0


MEASURED = Pace(dict.fromkeys(PARTS, (2.0, 1.1)))
SECONDS = st.floats(LEAST_SECONDS, 1e5)


def learned(*runs, kind=PLAIN, part="steady"):
    """Return a pace after runs that used so much and were typical of so much."""
    known = Learned()
    for used, typical in runs:
        known = known.after(used, typical)
    return MEASURED._replace(learned={label(kind, part): known})


def test_a_measurement_holds_until_runs_teach_better():
    assert MEASURED.rate(PLAIN, "steady").factor == pytest.approx(2.0)
    assert learned((12.0, 6.0), (3.0, 0.5)).rate(PLAIN, "steady").factor < 2.2  # small runs
    once = learned((600.0, 200.0)).rate(PLAIN, "steady")
    assert 2.7 < once.factor < 3.0
    often = learned(*[(30.0, 10.0)] * 100).rate(PLAIN, "steady")
    assert often.factor == pytest.approx(3.0, rel=0.01)
    assert LAWS <= often.spread < once.spread + 1e-9


@given(SECONDS, SECONDS)
def test_what_is_learned_lies_between_the_measurement_and_the_run(used, typical):
    factor = learned((used, typical)).rate(PLAIN, "steady").factor
    low, high = sorted((2.0, used / typical))
    assert low * (1.0 - 1e-9) <= factor <= high * (1.0 + 1e-9)


@given(st.lists(st.tuples(SECONDS, SECONDS), max_size=20))
def test_what_is_remembered_is_bounded_and_its_mean_lies_among_the_runs(runs):
    known = learned(*runs).learned[label(PLAIN, "steady")]
    assert 0.0 <= known.seconds <= MOST_SECONDS
    logs = [math.log(used / typical) for used, typical in runs] or [0.0]
    assert min(logs) - 1e-9 <= known.log <= max(logs) + 1e-9
    assert known.square >= known.log**2 - 1e-9
    for used, typical in ((0.5 * LEAST_SECONDS, 10.0), (10.0, 0.0)):  # moments teach nothing
        assert known.after(used, typical) == known


def test_runs_that_disagree_widen_the_interval():
    alike = learned((100.0, 50.0), (100.0, 50.0)).rate(PLAIN, "steady")
    apart = learned((100.0, 25.0), (100.0, 100.0)).rate(PLAIN, "steady")
    assert apart.factor == pytest.approx(alike.factor, rel=0.05)
    assert apart.spread > 3.0 * alike.spread


def test_one_kind_of_work_teaches_nothing_of_another():
    pace = learned((100.0, 10.0), kind=BRANCHES)
    assert pace.rate(PLAIN, "steady") == MEASURED.rate(PLAIN, "steady")
    assert pace.rate(BRANCHES, "jump") == MEASURED.rate(BRANCHES, "jump")
    assert pace.rate(BRANCHES, "steady").factor > 9.0


def test_of_other_code_the_machine_tells_how_quick_it_is_in_the_mean():
    quick = dict.fromkeys(PARTS, (0.5, 1.1)) | {"marching": (0.05, 1.1)}
    pace = Pace(quick)
    assert pace.rate(PLAIN, "marching").factor == pytest.approx(0.05)
    between = 0.5 * 0.1 ** (1.0 / len(PARTS))
    assert pace.rate(BRANCHES, "marching").factor == pytest.approx(between)
    assert pace.rate(BRANCHES, "steady").factor == pytest.approx(between)
    assert TYPICAL.rate(BRANCHES, "marching").factor == 1.0


def test_a_prediction_is_the_sum_of_its_parts_with_an_interval_about_it():
    pace = learned((300.0, 100.0))
    parts = {(PLAIN, "steady"): 10.0, (PLAIN, "marching"): 5.0}
    found = prediction(pace, parts)
    factor = pace.rate(PLAIN, "steady").factor
    assert found.seconds == pytest.approx(10.0 * factor + 5.0 * 2.0)
    assert found.low < found.seconds < found.high
    assert found.high / found.seconds == pytest.approx(found.seconds / found.low)
    assert prediction(pace, {}) == (0, 0, 0)


def test_where_nothing_is_known_the_interval_is_wide():
    parts = {(PLAIN, "steady"): 10.0}
    assert prediction(TYPICAL, parts).high > 1.3 * prediction(MEASURED, parts).high / 2.0


def test_no_pace_changes_a_key_or_a_number_of_lines():
    study = small_study("numerics.accuracy=0.1")
    plans = [make_plan(study, pace) for pace in (TYPICAL, MEASURED, learned((1e4, 1.0)))]
    for plan in plans:
        assert (plan.first, plan.expected) == (plans[0].first, plans[0].expected)
        assert [v.tasks for v in plan.variants] == [v.tasks for v in plans[0].variants]
    assert sum(plans[1].variants[0].seconds) > sum(plans[0].variants[0].seconds)
