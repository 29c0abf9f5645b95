"""Properties that hold for every body and material: steady states, jumps and marches.

Bodies are a line whose elements are all stepped, a line in blocks, the quick path of Kelvin
elements, a half-space, and a line and a half-space pulled through a spring. Each test combines a
property, a body and a material; tolerances belong to the body.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities, Spectrum, run_case
from elastomer_friction.kernels.drive import Drive, run_pulled
from elastomer_friction.kernels.half_space.cases import run_case as run_case_on_map
from elastomer_friction.kernels.half_space.scenes import (
    run_pulled_on_half_space,
    run_scene_on_half_space,
)
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Hold, Ramp, Sampled, Slide
from elastomer_friction.kernels.scene import TRACES, SavedState, run_scene, scene_steps
from tests.cases import bits, line_of
from tests.kernels.scene.given import ANY_MOTION, EVERY_LEG, MATERIALS, PULLS, a_line, a_scene
from tests.sizes import size

M, LOAD, SPEED = 4, 0.3, 0.7
SIDE = size(8, 6)  # side of a map, in elements
RECORDED = np.array([1, 2, 5, 13])
ALL = Quantities(initial_rate=True)


def line(shift=0.0):
    """Return a line, shifted by a number of spacings through its phases, which changes rounding."""
    return line_of(size(60, 20), shift, M)


def short_line():
    """Return a short line for pulls, because their steps are tried several times."""
    return a_line(20)


def surface(shift=0.0):
    """Return a map, shifted by whole spacings along x and by five samples across."""
    drawn = Surface.drawn(np.random.default_rng(1), ring_amplitudes(0.7, SIDE), SIDE, M)
    moved = (np.roll(field, (5 if shift else 0, int(shift) * M), (0, 1)) for field in drawn[:2])
    return Surface.from_samples(*moved, M)


def mirrored(body):
    """Return the mirror image of a line or map along x."""
    image = type(body).from_samples(body.z[..., ::-1], -body.slope[..., ::-1], M, body.band_limited)
    return image._replace(datum=body.datum) if isinstance(body, Line) else image


def taller(body, factor):
    """Return a line or map with all heights multiplied by a factor."""
    tall = body._replace(z=factor * body.z, slope=factor * body.slope)
    return tall._replace(datum=factor * body.datum) if isinstance(body, Line) else tall


def reversed_leg(leg):
    """Return a leg with all speeds reversed."""
    if isinstance(leg, Slide):
        return Slide(-leg.speed, leg.distance)
    if isinstance(leg, Ramp):
        return Ramp(-leg.first, -leg.last, leg.duration)
    if isinstance(leg, Sampled):
        return Sampled(leg.times, tuple(-speed for speed in leg.speeds))
    return leg


class CaseBody(NamedTuple):
    """Steady states, jumps and relaxations of a body, with tolerances under rounding."""

    geometry: Callable[..., Any]
    run: Callable[..., Any]
    materials: tuple[str, ...]
    mu: dict[str, float]
    curve: dict[str, float]


CASE_BODIES = {
    "quick line": CaseBody(line, run_case, ("kelvin",), {"rel": 1e-10}, {"abs": 1e-10}),
    "line": CaseBody(line, run_case, ("solid", "prony", "damped"), {"rel": 1e-9}, {"abs": 1e-9}),
    "map": CaseBody(surface, run_case_on_map, tuple(MATERIALS), {"abs": 1e-7}, {"abs": 1e-6}),
}
CASES = [(name, material) for name, body in CASE_BODIES.items() for material in body.materials]
REVERSIBLE = [row for row in CASES if row[0] != "quick line"]  # it slides forwards only


def case_of(name, material, requested=ALL, geometry=None, **changes):
    """Return the Outcome of one case for a body and a material."""
    body, spectrum = CASE_BODIES[name], MATERIALS.get(material, material)
    case = Case(LOAD, SPEED, (1.2,), (RECORDED,), "exponential", spectrum, refine=False)
    geometry = body.geometry() if geometry is None else geometry
    return body.run(geometry, case._replace(**changes), requested)


def assert_same_outcome(found, expected, name, sign=1.0):
    """Assert that outcomes agree within the tolerances of a body; sign : of their friction."""
    body = CASE_BODIES[name]
    assert found.mu_1 == pytest.approx(sign * expected.mu_1, **body.mu)
    assert found.mu_2 == pytest.approx(sign * expected.mu_2, **body.mu)
    assert found.jump == pytest.approx(sign * expected.jump, **body.curve)
    assert found.initial_rate == pytest.approx(
        sign * expected.initial_rate, nan_ok=True, rel=1e-5, abs=1e-9
    )
    assert found.curves[0] == pytest.approx(sign * expected.curves[0], **body.curve)
    assert found.indentation == pytest.approx(expected.indentation, rel=1e-10, abs=1e-7)
    assert found.contact_fraction == pytest.approx(expected.contact_fraction, rel=1e-10)
    assert found.samples_per_contact == expected.samples_per_contact


@pytest.mark.parametrize(("name", "material"), REVERSIBLE)
def test_a_mirror_image_slides_the_other_way(name, material):
    image = mirrored(CASE_BODIES[name].geometry())
    there, back = case_of(name, material), case_of(name, material, geometry=image, speed=-SPEED)
    assert_same_outcome(back, there, name, -1.0)


@pytest.mark.parametrize("shift", [1, 5])
@pytest.mark.parametrize(("name", "material"), CASES)
def test_a_cyclic_shift_changes_rounding_only(name, material, shift):
    moved = CASE_BODIES[name].geometry(shift)
    assert_same_outcome(case_of(name, material, geometry=moved), case_of(name, material), name)


@pytest.mark.parametrize("power", [-30, 7])
@pytest.mark.parametrize(("name", "material"), CASES)
def test_heights_and_loads_scale_together_bit_for_bit(name, material, power):
    """All pressures and slopes are multiplied by a power of two."""
    factor, plain = 2.0**power, case_of(name, material)
    tall = taller(CASE_BODIES[name].geometry(), factor)
    scaled = case_of(name, material, geometry=tall, load=factor * LOAD)
    back = scaled._replace(
        mu_1=scaled.mu_1 / factor,
        mu_2=scaled.mu_2 / factor,
        jump=scaled.jump / factor,
        initial_rate=scaled.initial_rate / factor,
        indentation=scaled.indentation / factor,
        curves=[curve / factor for curve in scaled.curves],
    )
    assert bits(back) == bits(plain)


def rearranged(spectrum):
    """Return a material with its branches in another order, and with one branch split."""
    (a, b, c), (s, t, u), viscosity = spectrum
    permuted = Spectrum((c, a, b), (u, s, t), viscosity)
    return permuted, Spectrum((0.25 * a, b, 0.75 * a, c), (s, t, s, u), viscosity)


@pytest.mark.parametrize("name", ["line", "map"])
def test_order_and_splitting_of_branches_change_nothing(name):
    """Bits are equal on a line; on a map, the complex modulus sums the branches in order."""
    plain = case_of(name, "prony")
    for spectrum in rearranged(MATERIALS["prony"]):
        actual = case_of(name, spectrum)
        if name == "line":
            assert bits(actual) == bits(plain)
        else:
            assert_same_outcome(actual, plain, name)
            assert actual.mu_1 == pytest.approx(plain.mu_1, rel=1e-12)
            np.testing.assert_array_equal(actual.jump, plain.jump)


STEADY = Quantities(jump=False, relaxation=False)


@pytest.mark.parametrize(("name", "material"), CASES)
def test_only_requested_quantities_are_computed(name, material):
    """A quantity does not depend on the other requested quantities."""
    everything, steady = case_of(name, material), case_of(name, material, STEADY)
    jump = case_of(name, material, Quantities(steady=False, relaxation=False))
    assert np.isnan(steady.jump).all()
    assert np.isnan(jump.mu_2).all()
    assert steady.curves == jump.curves == []
    assert np.isfinite(everything.jump).all()
    assert everything.curves[0].shape == RECORDED.shape
    np.testing.assert_array_equal(jump.jump, everything.jump)
    np.testing.assert_array_equal([steady.mu_1, *steady.mu_2], [everything.mu_1, *everything.mu_2])
    assert max(jump.work, steady.work) < everything.work


@pytest.mark.parametrize("name", CASE_BODIES)
def test_slow_friction_is_linear_in_the_speed_and_the_same_for_all_materials(name):
    """mu/(v tau) depends only on the loss at low frequencies, which is determined by tau."""
    slow = [
        [case_of(name, material, STEADY, speed=v).mu_1 / v for v in (1e-6, 2e-6)]
        for material in CASE_BODIES[name].materials
    ]
    assert np.min(slow) > 0.0
    np.testing.assert_allclose(slow, slow[0][0], rtol=1e-3)


@pytest.mark.parametrize("material", ["solid", "prony"])
@pytest.mark.parametrize("name", ["line", "map"])
def test_fast_friction_of_branches_falls_as_the_inverse_of_the_speed(name, material):
    """At high frequencies the material is an elastic glass, whose loss falls as 1/v."""
    fast = np.array([v * case_of(name, material, STEADY, speed=v).mu_1 for v in (1e5, 2e5)])
    assert fast[1] == pytest.approx(fast[0], rel=0.01)
    assert 0.0 < fast[0] / 1e5 < 1e-2 * case_of(name, material, STEADY).mu_1


class MarchBody(NamedTuple):
    """Marches of a body through programmes, with tolerances of friction."""

    geometry: Callable[..., Any]
    run: Callable[..., dict[str, np.ndarray]]  # function of geometry and scene
    scheme: str
    steady: float  # relative change of mu during steady sliding
    indentation: float  # relative change of the indentation during steady sliding
    mirror: float  # difference of mu and distance under reflection
    forces: float  # relative error of the normal force


def pull_line(body, scene):
    """Pull a line by a spring, a damper and a mass that follow the drive closely."""
    scale = LOAD * math.sqrt(np.mean(body.slope**2))
    return run_pulled(body, scene, Drive(*(scale * np.array((2.0, 0.1, 0.05)))))


def pull_map(body, scene, stiffness=None):
    """Pull a map in the same way as a line."""
    scale = LOAD * math.sqrt(np.mean(body.slope**2))
    drive = Drive(*(scale * np.array((2.0, 0.1, 0.05))))
    return run_pulled_on_half_space(body, scene, drive, stiffness)


MARCH_BODIES = {
    "elements": MarchBody(line, run_scene, "implicit-euler", 1e-9, 1e-12, 1e-9, 1e-10),
    "blocks": MarchBody(line, run_scene, "exponential", 1e-9, 1e-12, 1e-9, 1e-10),
    "map": MarchBody(surface, run_scene_on_half_space, "exponential", 1e-4, 1e-4, 1e-4, 1e-10),
    "pulled elements": MarchBody(short_line, pull_line, "implicit-euler", 1e-4, 1e-4, 5e-3, 1e-10),
    "pulled blocks": MarchBody(short_line, pull_line, "exponential", 1e-4, 1e-4, 5e-3, 1e-10),
    "pulled map": MarchBody(surface, pull_map, "exponential", 1e-4, 1e-4, 5e-3, 1e-10),
}
MARCHES = [
    (name, material)
    for name in MARCH_BODIES
    for material in (MATERIALS if name != "pulled map" else ("kelvin", "prony"))
]
MOVED = ("elements", "blocks", "map")
ON_LINES = ("elements", "blocks")


def march_of(name, legs, material, geometry=None, **changes):
    """Return the values of a march for a body and a material."""
    body, spectrum = MARCH_BODIES[name], MATERIALS.get(material, material)
    scene = a_scene(legs, spectrum, M, **{"scheme": body.scheme} | changes)
    return body.run(body.geometry() if geometry is None else geometry, scene)


@pytest.mark.parametrize("speed", [0.6, -0.6])
@pytest.mark.parametrize(("name", "material"), MARCHES)
def test_steady_sliding_stays_steady(name, material, speed):
    body, distance = MARCH_BODIES[name], 12.0 if name in ON_LINES else 3.0
    values = march_of(name, (Slide(speed, distance),), material)
    mu, d = values["trace_mu"], values["trace_indentation"]
    np.testing.assert_allclose(mu, mu[0], rtol=body.steady)
    np.testing.assert_allclose(d, d[0], rtol=body.indentation)
    assert mu[0] * speed > 0.0


@pytest.mark.parametrize(("name", "material"), MARCHES)
def test_a_mirror_image_marches_the_other_way(name, material):
    legs, body = PULLS[: 4 if name.endswith("map") else 5], MARCH_BODIES[name]
    if name in ON_LINES:
        legs = (Slide(0.5, 3.3), Hold(1.0), Ramp(0.3, -1.0, 4.0), *PULLS)
    there = march_of(name, legs, material)
    image = mirrored(body.geometry())
    back = march_of(name, tuple(map(reversed_leg, legs)), material, image)
    signs = {"mu": -1.0, "distance": -1.0, "contact_fraction": 1.0, "indentation": 1.0}
    for trace, sign in signs.items():
        actual, expected = back[f"trace_{trace}"], sign * there[f"trace_{trace}"]
        one_sample = 1.01 / image.z.size if trace == "contact_fraction" else 0.0  # may differ
        atol = max(body.mirror, one_sample if name == "map" else 0.0)
        np.testing.assert_allclose(actual, expected, rtol=0, atol=atol, err_msg=trace)


@pytest.mark.parametrize(("name", "material"), MARCHES)
def test_pressures_are_positive_and_carry_the_load(name, material):
    legs, body = PULLS if name.startswith("pulled") else EVERY_LEG[:4], MARCH_BODIES[name]
    requested = ("trace",)
    if name in ON_LINES:
        requested = ("trace", "state")
    elif name == "map":
        requested = ("trace", "snapshots")
    count = 6 if name == "map" else 0
    values = march_of(name, legs, material, requested=requested, frames=np.arange(count))
    np.testing.assert_allclose(values["trace_normal_force"], LOAD, rtol=body.forces)
    assert values["trace_contact_fraction"].min() > 0.0
    assert values["trace_contact_fraction"].max() <= 1.0
    p = values.get("state_p", values.get("snapshot_pressure"))
    if p is not None:
        assert p.min() >= 0.0


@pytest.mark.parametrize("material", MATERIALS)
@pytest.mark.parametrize("name", MOVED)
def test_a_zero_hold_changes_no_bit(name, material):
    one, two = Slide(0.5, 2.3), Slide(0.9, 2.0)
    without = march_of(name, (one, two), material)
    with_hold = march_of(name, (one, Hold(0.0), two), material)
    for key, values in without.items():
        np.testing.assert_array_equal(with_hold[key], values, err_msg=key)


@pytest.mark.parametrize("cut", [1, 3, 5])
@pytest.mark.parametrize("material", MATERIALS)
@pytest.mark.parametrize("name", ON_LINES)
def test_a_programme_cut_in_two_and_resumed_is_the_same_to_the_bit(name, material, cut):
    requested = ANY_MOTION if name == "blocks" else ("trace", "state")
    options = {"scheme": MARCH_BODIES[name].scheme, "requested": requested}
    options["edges"] = np.array([0.0, 1.0, 2.0, 4.0, 100.0])
    whole = a_scene(EVERY_LEG, MATERIALS[material], M, **options)
    first = run_scene(line(), a_scene(EVERY_LEG[:cut], MATERIALS[material], M, **options))
    state = SavedState(*(first[f"state_{field}"] for field in SavedState._fields))
    state = SavedState(*state[:2], *map(float, state[2:]))
    rest = whole._replace(programme=EVERY_LEG[cut:])
    count = scene_steps(rest, M, state.origin).dt.size
    second = run_scene(line(), rest._replace(recorded=np.arange(1, count + 1)), state)
    actual = run_scene(line(), whole)
    series = (*TRACES, "stored_energy") if name == "blocks" else TRACES
    for key in series:
        np.testing.assert_array_equal(np.append(first[key], second[key]), actual[key])
    for field in SavedState._fields:
        np.testing.assert_array_equal(second[f"state_{field}"], actual[f"state_{field}"])


@pytest.mark.parametrize("name", MARCH_BODIES)
def test_order_and_splitting_of_branches_change_no_bit_of_a_march(name):
    plain = march_of(name, PULLS[:2], "prony")
    for spectrum in rearranged(MATERIALS["prony"]):
        for key, values in march_of(name, PULLS[:2], spectrum).items():
            np.testing.assert_array_equal(values, plain[key], err_msg=key)


EQUALLY_STIFF = {  # legs, marches of line and map, maximum difference of a trace
    "moved": (EVERY_LEG, run_scene, run_scene_on_half_space, 6e-5),
    "pulled": ((Slide(1.3, 3.0), Hold(0.5), Slide(2.0, 2.0)), pull_line, pull_map, 1e-3),
}


@pytest.mark.parametrize(
    ("name", "start"), [("moved", "steady"), ("moved", "relaxed"), ("pulled", "steady")]
)
@pytest.mark.parametrize("material", MATERIALS)
def test_a_half_space_of_equal_stiffness_marches_as_the_line(material, name, start):
    """The mean of u, the area and samples per contact are defined differently."""
    other = {"trace_samples_per_contact", "trace_contact_fraction"}  # median; corrected for edges
    (legs, on_line, on_map, atol), line = EQUALLY_STIFF[name], a_line(12)
    surface = Surface.from_samples((line.z + line.datum)[None], line.slope[None], M)
    requested = ("trace", "cycle_mean") if name == "moved" else ("trace",)
    scene = a_scene(legs, MATERIALS[material], M, start=start, requested=requested)
    stiffness = np.full((1, line.z.size // 2 + 1), M / line.z.size)
    expected, result = on_line(line, scene), on_map(surface, scene, stiffness=stiffness)
    for key in expected:
        if key.startswith(("trace", "mu")) and key not in other:
            actual = result[key] + (scene.load if key == "trace_indentation" else 0.0)
            np.testing.assert_allclose(actual, expected[key], atol=atol, err_msg=key)
