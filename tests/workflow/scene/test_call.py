"""A scene from Python: its physics, units and dataset, and continued programmes."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.ground import UserError
from tests.workflow.scene.scenes import KELVIN, LENGTH, MATERIAL, PULL, N, heights, run, slide

EVERYTHING = ["steady", "trace", "peak", "relaxation", "rate_state", "energy", "contact_lengths"]


def final(*programme, **changed):
    """Return the last friction coefficient of a scene."""
    return run(*programme, **changed).trace_mu.values[-1]


@pytest.fixture(scope="module")
def stepped():
    """Return a velocity step with all quantities."""
    return run(slide(0.1, 64), slide(0.2, 64), quantities=EVERYTHING, numerics={"trace": 1})


def test_a_trace_starts_from_steady_sliding_and_has_a_sample_per_step(stepped):
    assert stepped.sizes["event"] == 1 + 4 * 128
    before = stepped.trace_segment.values[1:] == 0
    steady = stepped.trace_mu.values[1:][before]
    assert np.ptp(steady) < 1e-9 * abs(steady).max()
    assert set(stepped.dims) == {"event", "sample", "law", "bin", "wave_number"}
    assert np.isnan(stepped.trace_mu_error).all()  # of one line


def test_a_profile_is_marched_in_as_many_steps_as_a_study_takes():
    """They are fine enough, unlike one step per spacing."""
    own, coarse, fine = (run(numerics=n)["mu_1"].item() for n in (
        None, {"steps_per_spacing": 1}, {"steps_per_spacing": 32}
    ))  # fmt: skip
    assert own == pytest.approx(fine, rel=1e-3)
    assert coarse != pytest.approx(fine, rel=2e-3)


def test_a_velocity_in_arrays_is_the_segment_of_a_ramp():
    arrays = {"time": np.array([2.0, 2.0005]), "velocity": np.array([0.1, 0.2])}
    ramp = {"ramp": {"velocity": [0.1, 0.2], "duration": 5e-4}}
    assert run(arrays).attrs["programme"] == "2 samples over 0.0005 s, 0.1 to 0.2 m/s"
    assert np.array_equal(run(arrays).trace_mu.values, run(ramp).trace_mu.values)


def test_a_function_of_time_is_the_motion_that_segments_describe():
    swing = {"velocity": 0.1, "amplitude": 5e-6, "frequency": 1e3, "cycles": 1}
    speed = 2e3 * np.pi * 5e-6
    other = {"duration": 1e-3, "programme": lambda t: 0.1 + speed * np.cos(2e3 * np.pi * t)}
    rest = {"start": "relaxed"}
    assert final(**other, **rest) == pytest.approx(final({"oscillate": swing}, **rest), rel=3e-3)
    step = {"duration": 4e-4, "programme": lambda t: 0.1 if t < 2e-4 else 0.2}
    segments = [{"slide": {"velocity": v, "duration": 2e-4}} for v in (0.1, 0.2)]
    assert final(**step) == pytest.approx(final(*segments), rel=1e-3)


def test_a_function_of_time_moves_the_drive_if_there_is_one():
    drive = {"drive": {"stiffness": 1e4}, "duration": 1e-4}
    actual = run(programme=lambda t: 0.1, **drive)
    assert actual.trace_distance.values[-1] == pytest.approx(1e-5, rel=1e-2)
    assert "trace_drive_force" in actual


def test_everything_is_in_si(stepped):
    velocity = stepped.trace_velocity.values[1:]
    assert sorted(set(velocity.round(12))) == [0.1, 0.2]
    assert stepped.trace_distance.values[-1] == pytest.approx(LENGTH, rel=0.02)
    assert stepped.trace_time.values[-1] == pytest.approx(0.5 * LENGTH * (10 + 5), rel=0.02)
    assert stepped.trace_normal_force.values == pytest.approx(np.ones(513), rel=1e-9)
    mu = stepped.trace_friction_force / stepped.trace_normal_force
    assert mu.values == pytest.approx(stepped.trace_mu.values, rel=1e-9)
    assert float(stepped.tau) == pytest.approx(5 * 1e-3 + 10 * 1e-4)
    assert stepped["time"].attrs["units"] == stepped.peak_time.attrs["units"] == "s"


def test_friction_rises_at_the_initial_rate_and_peaks(stepped):
    assert float(stepped.peak) > 0.0
    assert 0.0 < float(stepped.peak_time) < 1e-3
    assert float(stepped.initial_rate) > 0.0
    mu, time = stepped.mu.values, stepped["time"].values
    slope = (mu[1] - stepped.mu_1.item()) / time[1]
    assert slope == pytest.approx(stepped.initial_rate.item(), rel=0.5)


def test_energy_is_balanced(stepped):
    assert abs(float(stepped.balance_residual)) < 0.02
    assert (np.diff(stepped.dissipated_energy.values) >= 0.0).all()
    assert stepped.stored_energy.attrs["units"] == "J"


def test_contacts_are_counted_by_their_length(stepped):
    assert 1.0 <= stepped.contact_length.sum() <= N / 2


def test_random_lines_have_errors():
    surface = {"length": 1e-4, "hurst": 0.7, "roughness": 1e-6, "spacing": 2e-6}
    actual = run(slide(), profile=None, length=None, surface=surface, realizations=4, seed=3)
    assert (actual.mu_1_error > 0.0).all()
    assert (actual.trace_mu_error.values > 0.0).all()


def test_a_dashpot_jumps_and_holds_make_a_dimension():
    hold = {"hold": {"duration": [1e-4, 1e-3]}}
    programme = slide(), hold, slide()
    actual = run(*programme, material=KELVIN, quantities=["trace", "healing"])
    assert actual.static_peak.dims == ("hold",)
    assert actual.hold.values.tolist() == [1e-4, 1e-3]
    assert (actual.static_peak > actual.mu_end_of_hold).all()
    jump = run(slide(0.1), slide(0.2), material=KELVIN, quantities=["jump"])
    assert float(jump["jump"]) > 0.0


def test_an_oscillation_at_an_indentation_makes_loops():
    swing = {"oscillate": {"amplitude": 1e-7, "frequency": 100.0, "cycles": 2}}
    pressed = {"normal_force": None, "prescribed_indentation": 1e-6}
    actual = run(swing, **pressed, start="relaxed", quantities=["trace", "loop"])
    assert actual.loop_work.item() > 0.0
    assert actual.mu_quadrature.item() > 0.0
    assert actual.prescribed_indentation.item() == 1e-6
    assert run(slide(), **pressed).attrs["quantities"] == "trace"


def test_colder_is_slower_exactly():
    wlf = {"c1": 10.0, "c2": 50.0, "reference": 20.0}
    cold = run(slide(0.1), material={**MATERIAL, "wlf": wlf, "temperature": 10.0})
    shift = 10.0 ** (100.0 / 40.0)
    fast = run(slide(0.1 * shift))
    assert cold.mu_1.item() == pytest.approx(fast.mu_1.item(), rel=1e-9)
    assert cold.trace_mu.values == pytest.approx(fast.trace_mu.values, rel=1e-9)


MASKED = np.ma.array(heights(), mask=np.arange(N) == 7)
ENDLESS: list = []
ENDLESS.append(ENDLESS)
PULLED = {"programme": [PULL], "drive": {"stiffness": 1e4}}


def test_arrays_without_dimensions_and_empty_masks_are_plain_values():
    given = {
        "profile": np.ma.array(heights(), mask=False),
        "length": np.array(LENGTH),
        "normal_force": np.array(1.0),
        "material": KELVIN | {"shear_modulus": np.array(1e6)},
        "body": np.array("foundation"),
    }
    assert run(**given).identical(run(material=KELVIN, body="foundation"))


def test_arrays_of_xarray_are_accepted_and_profiles_have_persson():
    own = {"time": xr.DataArray([0.0, 5e-4]), "velocity": xr.DataArray([0.1, 0.2])}
    other = {name: values.values for name, values in own.items()}
    asked = {"quantities": ["steady", "persson", "trace"]}
    actual = run(own, profile=xr.DataArray(heights()), **asked)
    assert actual.identical(run(other, **asked))
    assert actual.mu_persson > 0.0


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"normal_force": None}, "normal_force: give one of"),
        ({"surface": {"length": 1.0}}, "profile: give either profile"),
        ({"length": None}, "length: missing"),
        ({"length": -1.0}, "length = -1.0: must be greater than zero"),
        ({"profile": heights() * 1e3}, "slope"),
        ({"profile": heights() * 1e-6}, "slope"),
        ({"profile": heights() * 1e306}, "rms slope of the heights is"),
        ({"profile": heights() * 1e306, "body": "half-space"}, "rms slope of the heights is"),
        ({"length": 5e-324}, "rms slope of the heights is inf"),
        ({"length": 5e-324, "body": "half-space"}, "rms slope of the heights is inf"),
        ({"profile": np.empty((0, N))}, "profile: has the shape (0, 128)"),
        ({"profile": 10**400}, "profile: must be an array of heights"),
        ({"normal_force": {"linspace": [0, 1.797e308, 4]}}, "grid.normal_force"),
        ({"normal_force": {"geomspace": [1, 1.7976931348622103e308, 2]}}, "grid.normal_force"),
        ({"normal_force": 1e12}, "grid.normal_force"),
        ({"material": 3.0}, "material = 3.0: must be a dictionary"),
        ({"quantities": ["jump"]}, "jump"),
        ({"length": -0.0}, "length = -0.0: must be greater than zero"),
        ({"length": np.array([LENGTH])}, "must be a finite number"),
        ({"profile": heights() + 1j}, "profile: must be an array of heights"),
        ({"profile": heights() + 0j, "body": "half-space"}, "profile: must be an array of heights"),
        ({"profile": MASKED}, "1 of 128 are masked"),
        ({"profile": np.ma.array(np.eye(16), mask=np.eye(16)), "body": "half-space"}, "is nan"),
        ({"normal_force": np.ma.masked}, "normal_force: holds masked values"),
        ({"material": KELVIN | {"shear_modulus": np.ma.masked}}, "material: holds masked values"),
        ({"material": KELVIN | {"branches": ENDLESS}}, "material: holds itself"),
        ({"body": np.array([1, 2])}, "scene.body = [1, 2]: must be one of"),
        ({"body": xr.DataArray([1, 2])}, "scene.body = [1, 2]: must be one of"),
        ({"programme": [{"hold": {"duration": np.timedelta64(1, "ns")}}]}, "times as numbers in s"),
        ({"duration": 1.0}, "duration = 1.0: belongs to a programme that is a function of time"),
        ({"programme": lambda t: 0.1}, "duration: missing"),
        ({"programme": lambda t: 0.1, "duration": 0.0}, "duration = 0.0: must be greater"),
        ({"state": 3}, "state = 3: must be a dataset"),
        (PULLED | {"drive": {"stiffness": -1.0}}, "scene.drive.stiffness = -1.0: must be greater"),
        (PULLED | {"drive": {"stiffness": 1.0, "mass": np.nan}}, "scene.drive.mass = nan: must be"),
        (PULLED | {"drive": {"mass": 1.0}}, "scene.drive.stiffness: missing"),
        (PULLED | {"drive": 3.0}, "drive = 3.0: must be a dictionary"),
        (PULLED | {"quantities": ["trace", "state"]}, '"state": is not available for a line'),
    ],
)
def test_invalid_arguments_are_refused_in_one_line(changed, words):
    with pytest.raises(UserError) as error:
        run(**changed)
    assert words in str(error.value)
    assert "\n" not in str(error.value)


def test_the_dataset_has_no_grid_and_its_provenance():
    actual = run(
        slide(), quantities=["steady", "relaxation", "peak"], programme=[slide(), slide(0.2)]
    )
    assert "hurst" not in actual.coords  # a measured line has none
    assert actual.normal_force.dims == ()
    assert actual.attrs["lines"].startswith("given from Python")
    assert {"code", "commit", "versions", "study"} <= actual.attrs.keys()
    assert actual.relaxation_rate.attrs["units"] == "s-1"
    assert "alpha" not in actual
    assert "power_spectrum" in actual


STEPS = {"trace": 1}
ASKED = {"quantities": ["trace", "state"], "numerics": STEPS}


@pytest.fixture(scope="module")
def first():
    """Return the first half of a programme."""
    return run(slide(0.1, 32), **ASKED)


def test_two_halves_are_the_whole_to_the_bit(first):
    second = run(slide(0.1, 32), **ASKED, state=first)
    whole = run(slide(0.1, 32), slide(0.1, 32), **ASKED)
    for name in ("trace_mu", "trace_indentation", "trace_contact_fraction"):
        assert np.array_equal(second[name].values[1:], whole[name].values[129:]), name
    for name in ("state_memory", "state_p", "state_d", "state_position"):
        assert np.array_equal(second[name].values, whole[name].values), name
    assert second.trace_time.values[1:] == pytest.approx(whole.trace_time.values[129:], rel=1e-12)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"profile": 1.1 * heights()}, "belongs to another line"),
        ({"material": {"shear_modulus": 2e6, "relaxation_time": 1e-3}}, "another line, material"),
        ({"seed": 3}, "seed"),
        ({"state": xr.Dataset()}, 'state: state_memory is missing; request the quantity "state"'),
    ],
)
def test_a_state_of_another_scene_and_a_missing_state_are_refused(first, changed, words):
    with pytest.raises(UserError, match=words):
        run(slide(), **(ASKED | {"state": first} | changed))
