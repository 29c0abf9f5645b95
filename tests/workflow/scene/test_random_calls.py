"""``scene.run`` returns a dataset or raises an error of printable lines, for any arguments.

``make fuzz`` runs the same again and again for FUZZ_SECONDS.
"""

import copy
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow import scene
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan import make_plan
from elastomer_friction.workflow.scene import call
from elastomer_friction.workflow.study.effects.material import MATERIAL
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from elastomer_friction.workflow.study.effects.segment_keys import DRIVE
from elastomer_friction.workflow.study.numerics import NUMERICS
from elastomer_friction.workflow.study.surfaces.table import SURFACE
from tests.workflow.scene.scenes import KELVIN, LENGTH, heights, slide
from tests.workflow.scene.scenes import MATERIAL as BRANCHED
from tests.workflow.study.test_fuzz import FUZZ, NUMBERS, VALUES

N = 32
MOST_SECONDS = 2.0  # of a computed scene; longer ones are only planned
SMALL = {"length": LENGTH, "normal_force": 1.0, "material": KELVIN}
PROFILE = {"profile": heights(N)}
RANDOM = {
    "surface": {"length": LENGTH, "hurst": 0.7, "roughness": 1e-6, "spacing": 4e-6},
    "length": None,
}
MAP = {"profile": np.add.outer(heights(16), heights(16)), "body": "half-space"}
SLIDES = [slide(0.1, 16), slide(0.2, 16)]
SLIDE = slide(0.1, 8)
HOLD = {"hold": {"duration": [1e-4, 1e-3]}}
SWING = {"oscillate": {"amplitude": 1e-7, "frequency": 100.0, "cycles": 2}}
RAMP = {"ramp": {"velocity": [0.1, 0.2], "duration": 5e-5}}
PULL = {"pull": {"velocity": 0.1, "distance": LENGTH / 4}}
ARRAYS = {"time": np.array([0.0, 5e-5]), "velocity": np.array([0.1, 0.2])}
SCENES = [
    PROFILE | {"programme": SLIDES},
    PROFILE | {"programme": SLIDES, "material": BRANCHED, "quantities": ["steady", "relaxation"]},
    PROFILE | {"programme": [SLIDE, HOLD, SLIDE], "quantities": ["trace", "healing"]},
    PROFILE | {"programme": [SWING], "start": "relaxed", "quantities": ["trace", "loop", "energy"]},
    PROFILE | {"programme": [RAMP, ARRAYS], "quantities": ["trace", "contact_lengths", "state"]},
    PROFILE | {"programme": [PULL], "drive": {"stiffness": 100.0}, "start": "relaxed"},
    RANDOM | {"programme": SLIDES, "realizations": 4},
    MAP | {"programme": [slide(0.1, 4)], "start": "relaxed", "quantities": ["trace"]},
]  # fmt: skip


class Odd:
    """An object that is not a number and has no other methods."""

    def __array__(self, dtype=None, copy=None):
        """Refuse to be an array."""
        raise TypeError("no array")


ARRAY_KINDS = ["f8", "f4", "f2", "i1", "u8", "?", "c16", "O", "U3", "M8[s]", "longdouble", "V8"]
ODD = st.one_of(
    st.sampled_from([
        None, True, "auto", "half-space", "a\nb", b"1", 1j, np.nan, -np.inf, np.float32(0.1), Odd(),
        Odd, len, {1, 2}, range(3), Ellipsis, Decimal("0.1"), Fraction(1, 3), np.ma.masked, -0.0,
        np.datetime64("2020-01-01"), np.timedelta64(1, "s"), np.array(1.0), np.array([[]]), 10**400,
        np.zeros((2, 2), [("a", "f8")]), xr.DataArray([0.0, 1.0, 0.5, 0.2]), xr.Dataset(), {}, [],
        {1: 2}, {None: {}}, (0.1, 0.2), memoryview(b"1234"), iter([1.0]), np.bool_(True),
    ]),
    NUMBERS,
    VALUES,
)  # fmt: skip
PROFILES = st.one_of(
    st.builds(
        lambda count, scale, kind: _of_kind(scale * heights(max(count, 1))[:count], kind),
        st.integers(0, 40),
        st.sampled_from([1.0, -1.0, 1e-3, 1e3, 0.0, 1e300, 1e-300]),
        st.sampled_from(ARRAY_KINDS),
    ),
    st.builds(
        lambda place, odd: _with(heights(N), place, odd),
        st.integers(0, N - 1),
        st.sampled_from([np.nan, np.inf, 1e308, -1e-5, 5e-324]),
    ),
    st.builds(lambda place: np.ma.array(heights(N), mask=np.arange(N) == place), st.integers(0, N)),
    st.builds(
        lambda shape: np.resize(heights(N), shape),
        st.lists(st.integers(0, 9), max_size=3).map(tuple),
    ),
    st.sampled_from([heights(2 * N)[::2], heights(N)[::-1], heights(N).tolist(), ">f8"]).map(
        lambda found: heights(N).astype(found) if isinstance(found, str) else found
    ),
    st.lists(st.one_of(NUMBERS, ODD), max_size=5),
    ODD,
)
SEGMENT = st.sampled_from([*SLIDES, HOLD, SWING, RAMP, PULL, ARRAYS, slide(0.0), slide(-0.1, 8)])
SPEED_KEYS = ["velocity", "ratio", "distance", "duration", "amplitude", "frequency", "cycles"]
PROGRAMMES = st.one_of(
    st.lists(SEGMENT, max_size=4),
    st.lists(
        st.one_of(
            SEGMENT,
            st.dictionaries(
                st.sampled_from(["slide", "hold", "ramp", "oscillate", "pull"]),
                st.dictionaries(st.sampled_from(SPEED_KEYS), st.one_of(NUMBERS, ODD), max_size=3),
                max_size=2,
            ),
            st.fixed_dictionaries({"time": st.one_of(PROFILES, ODD), "velocity": PROFILES}),
            ODD,
        ),
        max_size=3,
    ),
    ODD,
)


def _of_kind(values, kind):
    """Return values converted to a type of array."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return values.astype("f8" if kind == "V8" else kind).astype(kind)


def _with(values, place, odd):
    values[place] = odd
    return values


def table_of(keys, *sound):
    """Return tables with some of the keys, with the values of a valid table or odd ones."""
    changed = st.dictionaries(st.sampled_from([*keys]), st.one_of(NUMBERS, ODD), max_size=2)
    whole = st.builds(lambda table, other: {**table, **other}, st.sampled_from(sound), changed)
    return st.one_of(whole, whole, ODD)


QUANTITY = st.sampled_from([*QUANTITIES, "other"])
ARGUMENTS = {
    "profile": PROFILES,
    "length": ODD,
    "surface": table_of([*SURFACE, *call.GRID_KEYS], RANDOM["surface"], {}),
    "material": table_of(MATERIAL, KELVIN, BRANCHED),
    "normal_force": ODD,
    "normal_pressure": ODD,
    "prescribed_indentation": ODD,
    "programme": PROGRAMMES,
    "drive": table_of(DRIVE, {"stiffness": 100.0}, {"stiffness": 1e4, "mass": 1e-3}),
    "body": ODD,
    "start": st.one_of(st.sampled_from(["steady", "relaxed", "fresh"]), ODD),
    "repeat": st.one_of(st.integers(-1, 3), ODD),
    "quantities": st.one_of(st.lists(QUANTITY, max_size=4), ODD),
    "numerics": table_of(NUMERICS, {"samples": 16}, {"trace": 1}, {"steps_per_spacing": 2}),
    "realizations": st.one_of(st.integers(-1, 8), ODD),
    "seed": ODD,
    "state": ODD,
}
ONE_CHANGE = st.one_of(*(st.tuples(st.just(name), values) for name, values in ARGUMENTS.items()))


class TooLong(Exception):
    """The predicted time of a scene exceeds MOST_SECONDS."""


def outcome(arguments):
    """Return the dataset of a scene, the message it is refused with, or None if it takes long."""

    def plan_if_short(study, **more):
        plan = make_plan(study, **more)
        if plan.predicted_seconds() > MOST_SECONDS:
            raise TooLong
        return plan

    usual, call.make_plan = call.make_plan, plan_if_short
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return scene.run(**arguments)
    except UserError as error:
        return str(error)
    except TooLong:
        return None
    finally:
        call.make_plan = usual


def check(found):
    """Assert that an outcome is a dataset with its provenance, or a printable message."""
    if isinstance(found, xr.Dataset):
        assert found.attrs["study"]
        assert found.data_vars
    elif found is not None:
        assert found
        assert all(line.isprintable() for line in found.split("\n")), found


@FUZZ
@given(st.sampled_from(SCENES), st.lists(ONE_CHANGE, max_size=2))
def test_a_call_with_random_arguments_is_computed_or_refused(sound, changes):
    arguments = copy.deepcopy(SMALL | sound) | dict(changes)
    check(outcome(arguments))


def test_each_scene_that_the_fuzz_changes_is_computed():
    for sound in SCENES:
        assert isinstance(outcome(SMALL | sound), xr.Dataset), sound
