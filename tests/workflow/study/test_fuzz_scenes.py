"""Whatever the keys of a scene hold, it is read as a study, or refused with one line."""

import copy
import tomllib

from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.documents import document
from tests.support.small import FILES, TEXT
from tests.workflow.study import test_fuzz as fuzz
from tests.workflow.study.test_fuzz import FUZZ, NUMBERS, SPACED, VALUES

SLIDE = {"slide": {"velocity": 0.1, "distance": 1e-3}}
FASTER = {"slide": {"ratio": 1.2, "duration": 1e-3}}
HOLD = {"hold": {"duration": [1e-3, 1.0]}}
SWING = {"oscillate": {"velocity": 0.1, "amplitude": 1e-4, "frequency": 10, "cycles": 2}}
RAMP = {"ramp": {"velocity": [0.1, -0.2], "duration": 1.0}}
FILE = {"file": "velocity.csv"}
ALL = list(QUANTITIES)
SPEEDS = st.one_of(st.sampled_from([0.1, -0.1, 0, 1]), NUMBERS, st.lists(NUMBERS, max_size=3))
DURATIONS = st.one_of(st.sampled_from([1e-3, 1.0]), NUMBERS, SPACED, st.lists(NUMBERS, max_size=2))
SEGMENT_KEYS = {
    "velocity": SPEEDS,
    "ratio": SPEEDS,
    "distance": DURATIONS,
    "duration": DURATIONS,
    "amplitude": NUMBERS,
    "velocity_amplitude": NUMBERS,
    "frequency": NUMBERS,
    "cycles": st.one_of(st.integers(-1, 5), NUMBERS),
}
GOOD = st.sampled_from([SLIDE, FASTER, HOLD, SWING, RAMP, FILE])
SEGMENTS = st.one_of(
    GOOD,
    GOOD,
    st.dictionaries(
        st.sampled_from(["slide", "hold", "ramp", "oscillate"]),
        st.dictionaries(st.sampled_from(list(SEGMENT_KEYS)), VALUES, max_size=3),
        max_size=2,
    ),
    st.builds(
        lambda key, value: {"slide": {"velocity": 1, key: value}}, st.text(max_size=3), VALUES
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
    ("scene", "quantities"): st.lists(st.sampled_from(ALL), max_size=4),
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
    ("compare", "other"): st.fixed_dictionaries({"branches": BRANCHES}),
    ("numerics", "trace"): st.integers(-1, 10),
    ("numerics", "accuracy"): st.floats(0.01, 0.1),
}
CHANGES = st.lists(
    st.one_of(*(st.tuples(st.just(at), values) for at, values in KEYS.items())), max_size=3
)
PROGRAMMES = st.one_of(st.none(), st.just([SLIDE, FASTER]), st.lists(GOOD, min_size=1, max_size=4))


def scene_text(programme, control, changes):
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
        tables.setdefault(table, {})[key] = value
    return document(tables)


@FUZZ
@given(PROGRAMMES, st.sampled_from(["force", "indentation"]), CHANGES)
def test_a_scene_with_random_changes_is_read_or_refused(programme, control, changes):
    fuzz.check(fuzz.outcome(scene_text(programme, control, changes), planned=False))
