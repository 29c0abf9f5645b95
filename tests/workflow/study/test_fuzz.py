"""Whatever a TOML file holds, it is read as a study and planned, or refused with one line.

``make fuzz`` runs the same again and again for FUZZ_SECONDS.
"""

import copy
import math
import tempfile
import tomllib
from pathlib import Path

from hypothesis import example, given, settings
from hypothesis import strategies as st

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from elastomer_friction.workflow.study.effects.segment_keys import OSCILLATE, SEGMENTS, SLIDE
from elastomer_friction.workflow.study.measured import Measured
from elastomer_friction.workflow.study.read import known_studies, read_study
from elastomer_friction.workflow.study.study import Study
from elastomer_friction.workflow.study.tables import TABLES
from tests.support.documents import document
from tests.support.small import FILES, TEXT, small_study, write_study
from tests.support.sweeps import examples

FUZZ = settings(max_examples=examples(50), deadline=None)  # of each kind
MOST_POINTS = 100  # of a study to plan
MOST_ELEMENTS = 10_000
TEXTS = [TEXT, *(path.read_text() for path in sorted(known_studies().values()))]
TABLE_NAMES = [*TABLES, "compare", "scales", "measure", "other"]
NAMES = sorted(
    {key for keys in TABLES.values() for key in keys}
    | {"smoke", "x y", "linspace", "jobs", "cores", "memory", "walltime", "prologue", "where", ""}
)
NUMBERS = st.one_of(
    st.integers(-(2**70), 2**70),
    st.integers(10**300, 10**320),
    st.floats(1e-12, 1e12),
    st.floats(-1e3, 1e3, allow_subnormal=False),
    st.floats(),
    st.sampled_from([0.0, 1, 2, 4, 0.5, 5e-324, 1.7e308, 0.01 / 3, 1e-4]),
)
SCALARS = st.one_of(
    NUMBERS,
    st.booleans(),
    st.dates(),
    st.times(),
    st.text(max_size=5).filter(lambda text: "\x7f" not in text),
    st.sampled_from(["", "auto", "steady", "exponential", "modal", "a\nb", "µ", "'", "slurm"]),
)
SPACED = st.builds(
    lambda kind, first, last, count: {kind: [first, last, count]},
    st.sampled_from(["linspace", "geomspace"]),
    NUMBERS,
    NUMBERS,
    st.one_of(st.integers(-2, 50), NUMBERS),
)
VALUES = st.one_of(
    SCALARS,
    st.lists(st.one_of(SCALARS, st.lists(SCALARS, max_size=2)), max_size=3),
    SPACED,
    st.dictionaries(st.sampled_from(NAMES), st.one_of(SCALARS, st.lists(SCALARS)), max_size=2),
)
PLACES = st.tuples(st.sampled_from(TABLE_NAMES), st.sampled_from(NAMES))
PIECES = st.one_of(
    st.text(max_size=3),
    st.sampled_from([*'[]{}="\n#,', "[[", '"""', "'''", "nan", "-inf", "1e400", "1_0", "0x1F"]),
    st.sampled_from(["1979-05-27T07:32:00Z", "\\u0000", "\ufeff", "[grid]", "a.b=1"]),
)
EDITS = st.lists(st.tuples(st.floats(0.0, 1.0), st.integers(0, 8), PIECES), min_size=1, max_size=4)
SETTINGS = st.one_of(
    st.text(max_size=12),
    st.builds(
        lambda place, sign, value: f"{place[0]}.{place[1]}{sign}{value}",
        PLACES,
        st.sampled_from(["=", " = ", "", "==", "\n="]),
        st.one_of(st.text(max_size=8), NUMBERS.map(str), PIECES),
    ),
)


def outcome(text, *given_settings, scale=None, planned=True):
    """Return the study that a text makes and plan it, or the message it is refused with."""
    try:
        study = small_study(*given_settings, text=text, scale=scale)
        small = planned and isinstance(study, Study) and math.prod(study.shape) <= MOST_POINTS
        if small and study.surface.length / min(study.grid["spacing"]) <= MOST_ELEMENTS:
            make_plan(study)
    except UserError as error:
        return str(error)
    return study


def check(found):
    """Assert that an outcome is a study, or a message of one line for each thing that is wrong."""
    if not isinstance(found, Study | Measured):
        assert found
        assert all(line.isprintable() for line in found.split("\n")), found


@FUZZ
@given(st.sampled_from(TEXTS), EDITS)
def test_an_edited_text_is_read_or_refused(text, edits):
    for at, length, piece in edits:
        place = int(at * len(text))
        text = text[:place] + piece + text[place + length :]
    check(outcome(text))


@FUZZ
@given(st.lists(SETTINGS, min_size=1, max_size=3), st.one_of(st.none(), st.text(max_size=6)))
def test_random_settings_are_read_or_refused(given_settings, scale):
    check(outcome(TEXT, *given_settings, scale=scale))


@FUZZ
@given(st.binary(max_size=60))
@example(b"\xef\xbb\xbf" + TEXT.encode())
@example(TEXT.encode("utf-16"))
@example(b"a=" + b"[" * 5000)
def test_random_bytes_are_read_or_refused(content):
    with tempfile.TemporaryDirectory() as folder:
        path = write_study(folder)
        Path(path).write_bytes(content)
        try:
            check(read_study(path))
        except UserError as error:
            check(str(error))


def test_the_text_written_for_the_fuzz_is_the_study_it_came_from():
    actual = outcome(document(tomllib.loads(TEXT)))
    assert isinstance(actual, Study)
    assert actual.grid == small_study().grid


SLIDING = {"slide": {"velocity": 0.1, "distance": 1e-3}}
FASTER = {"slide": {"ratio": 1.2, "duration": 1e-3}}
HOLD = {"hold": {"duration": [1e-3, 1.0]}}
SWING = {"oscillate": {"velocity": 0.1, "amplitude": 1e-4, "frequency": 10, "cycles": 2}}
RAMP = {"ramp": {"velocity": [0.1, -0.2], "duration": 1.0}}
FILE = {"file": "velocity.csv"}
GOOD = st.sampled_from([SLIDING, FASTER, HOLD, SWING, RAMP, FILE])
SEGMENTS = st.one_of(
    GOOD,
    GOOD,
    st.dictionaries(
        st.sampled_from(list(SEGMENTS)),
        st.dictionaries(st.sampled_from([*OSCILLATE, *SLIDE, ""]), VALUES, max_size=3),
        max_size=2,
    ),
    st.builds(lambda name: {"file": name}, st.sampled_from([*FILES, "none.csv", "", "a\nb"])),
    VALUES,
)
BRANCHES = st.lists(
    st.one_of(st.lists(st.floats(1e-3, 1e9), min_size=2, max_size=2), VALUES), max_size=4
)
WLF = st.fixed_dictionaries(dict.fromkeys(("c1", "c2", "reference"), NUMBERS))
KEYS = {
    ("scene", "programme"): st.lists(SEGMENTS, max_size=4),
    ("scene", "quantities"): st.lists(st.sampled_from(list(QUANTITIES)), max_size=4),
    ("scene", "control"): st.sampled_from(["force", "indentation", "none"]),
    ("scene", "start"): st.sampled_from(["steady", "relaxed", "fresh", ""]),
    ("scene", "repeat"): st.integers(-1, 2000),
    ("scene", "indentation_file"): st.sampled_from(list(FILES)),
    ("scene", "indentation_rate"): st.booleans(),
    ("grid", "prescribed_indentation"): st.one_of(NUMBERS, SPACED),
    ("grid", "velocity"): st.one_of(NUMBERS, SPACED),
    ("material", "branches"): BRANCHES,
    ("material", "branches_file"): st.sampled_from(list(FILES)),
    ("material", "relaxation_time"): st.one_of(st.just(0), NUMBERS),
    ("material", "temperature"): st.one_of(st.floats(-60.0, 100.0), SPACED),
    ("material", "wlf"): st.one_of(st.just({"c1": 9, "c2": 100, "reference": 20}), WLF),
    ("material", "arrhenius"): st.fixed_dictionaries(
        dict.fromkeys(("activation_energy", "reference"), NUMBERS)
    ),
    ("material", "shifts"): BRANCHES,
    ("material", "shifts_file"): st.sampled_from(list(FILES)),
    ("compare", "other"): st.fixed_dictionaries({"branches": BRANCHES}),
    ("numerics", "trace"): st.integers(-1, 10),
    ("numerics", "accuracy"): st.floats(0.01, 0.1),
}
CHANGES = st.lists(
    st.one_of(
        st.tuples(PLACES, VALUES),
        st.tuples(st.tuples(st.sampled_from(TABLE_NAMES), st.none()), VALUES),  # a whole table
        *(st.tuples(st.just(at), values) for at, values in KEYS.items()),
    ),
    max_size=3,
)
PROGRAMMES = st.one_of(
    st.none(), st.just([SLIDING, FASTER]), st.lists(GOOD, min_size=1, max_size=4)
)


def changed_text(programme, control, changes):
    """Return the small study with a programme, under a control, and then some changes."""
    tables = copy.deepcopy(tomllib.loads(TEXT))
    if programme is not None:
        del tables["grid"]["velocity_step"]
        if FASTER not in programme and programme[0] is not HOLD:
            del tables["grid"]["velocity"]
        tables["scene"] = {"programme": programme, "control": control}
        if control == "indentation":
            del tables["grid"]["normal_force"]
            tables["grid"]["prescribed_indentation"] = 1e-5
    for (table, key), value in changes:
        own = tables.setdefault(table, {})
        if key is None or not isinstance(own, dict):
            tables[table] = value
        else:
            own[key] = value
    return document(tables)


@FUZZ
@given(PROGRAMMES, st.sampled_from(["force", "indentation"]), CHANGES, st.booleans())
def test_a_study_with_random_changes_is_read_or_refused(programme, control, changes, scaled):
    text = changed_text(programme, control, changes)
    check(outcome(text, scale="wide" if scaled else None, planned=programme is None))
