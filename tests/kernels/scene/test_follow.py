"""Following a programme: against the march, analytic answers, symmetries, the other scheme."""

import ast
import inspect
import math
import textwrap

import numba
import numpy as np
import pytest

from kernels import SCHEMES, ConstantForce, lagged_slope, march, steady_sliding
from kernels.jit import FLAGS
from kernels.motion.programme import Hold, Oscillation, Ramp, Slide, steps_of
from kernels.motion.track import tracks
from kernels.rheology.forms import FORMS
from kernels.rheology.retardation import retardation
from kernels.rheology.spectrum import KELVIN, complex_modulus, relaxation_modulus
from kernels.scene import run_scene, trace_stamps
from kernels.scene.begin import relaxed
from kernels.scene.follow import follow
from kernels.scene.records import Trace
from kernels.surfaces.line import Line
from tests.convergence import observed_order
from tests.kernels.scene.given import MATERIALS, PRONY, SOLID, a_line, a_scene, trace
from tests.sizes import PLAIN_PYTHON, size


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("ratio", [0.6, 1.6])
def test_kelvin_after_a_jump_is_the_march_to_rounding(scheme, ratio):
    line = a_line()
    n, m = line.z.size, line.steps_per_spacing
    before, after = (SCHEMES[scheme](1.0 / (m * v)) for v in (0.5, 0.5 * ratio))
    state, _ = steady_sliding(before, line.z, 0.3 * n)
    kept = np.arange(1, size(600, 60) + 1)
    weight = lagged_slope(line.slope, after.lag)
    control = ConstantForce(0.3 * n)
    mu, d, _, _ = march(after, control, line.z, weight, state, kept, np.inf)
    # One step at the old speed: it stays in the steady state.
    programme = (Slide(0.5, 1.0 / m), Slide(0.5 * ratio, kept.size / m))
    found = trace(line, programme, KELVIN, scheme=scheme)
    np.testing.assert_allclose(found["trace_mu"][2:], mu, rtol=0, atol=1e-13)
    acting = d + after.lag * (np.append(state.d, d[:-1]) - d)
    np.testing.assert_allclose(found["trace_indentation"][2:] - line.datum, acting, rtol=1e-13)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("speed", [0.6, -0.6])
def test_steady_sliding_stays_steady(name, speed):
    found = trace(a_line(), (Slide(speed, 12.0),), MATERIALS[name])
    d, mu = found["trace_indentation"], found["trace_mu"]
    np.testing.assert_allclose(d, d[0], rtol=1e-12)
    np.testing.assert_allclose(mu, mu[0], rtol=1e-9)
    assert mu[0] * speed > 0.0


@pytest.mark.parametrize("name", ["kelvin", "prony"])
def test_a_zero_hold_changes_no_bit(name):
    line, one, two = a_line(), Slide(0.5, 2.3), Slide(0.9, 2.0)
    without = trace(line, (one, two), MATERIALS[name])
    with_it = trace(line, (one, Hold(0.0), two), MATERIALS[name])
    for key, values in without.items():
        np.testing.assert_array_equal(with_it[key], values)


@pytest.mark.parametrize("name", ["kelvin", "prony"])
def test_the_mirror_image_slides_the_other_way(name):
    line = a_line()
    mirrored = Line.from_samples(line.z[::-1], -line.slope[::-1], line.steps_per_spacing)
    there = (Slide(0.5, 3.3), Hold(1.0), Ramp(0.3, -1.0, 4.0))
    back = (Slide(-0.5, 3.3), Hold(1.0), Ramp(-0.3, 1.0, 4.0))
    one, two = trace(line, there, MATERIALS[name]), trace(mirrored, back, MATERIALS[name])
    np.testing.assert_allclose(two["trace_mu"], -one["trace_mu"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(two["trace_indentation"], one["trace_indentation"], rtol=1e-9)


@pytest.mark.parametrize("name", ["solid", "prony"])
def test_both_schemes_agree_at_second_order(name):
    """Over a start from rest, a hold, a reversal and a ramp: they share the contact step alone."""
    programme = (
        Slide(4.0, 2.0),
        Hold(1.0),
        Slide(4.0, 1.3),
        Slide(-6.0, 2.0),
        Ramp(2.0, 16.0, 0.3),
    )
    refinements = np.array([8, 16, 32])[: size(3, 2)]
    errors = np.empty((refinements.size, 2))
    for k, m in enumerate(refinements):
        for seed in range(2):
            line = a_line(20, 1.0, m, seed)
            one, two = (
                trace(line, programme, MATERIALS[name], start="relaxed", scheme=scheme)["trace_mu"]
                for scheme in FORMS
            )
            errors[k, seed] = np.sqrt(np.mean((one - two) ** 2))
    assert observed_order(refinements, errors) > size(1.5, 0.5)
    assert errors[-1].max() < size(1e-3, 1e-1)


def response(spectrum, omega, m, cycles):
    """Return F_x over X, in 4 G L h^2/dx per dx, of a small oscillation in full contact."""
    amplitude = 0.03 / m
    x = np.arange(16 * m) / m
    line = Line.from_samples(np.cos(Q * x), -Q * np.sin(Q * x), m)
    programme = (Oscillation(0.0, amplitude, omega / (2.0 * math.pi), cycles),)
    scene = a_scene(programme, spectrum, m, start="relaxed", indentation=30.0)
    found, stamps = run_scene(line, scene), trace_stamps(scene, m)
    last = slice(-16 * m, None)
    waves = np.stack([f(omega * stamps["time"][last]) for f in (np.sin, np.cos)], axis=1)
    measured, *_ = np.linalg.lstsq(waves, found["trace_friction_force"][last], rcond=None)
    return complex(*measured) / amplitude


Q = 2.0 * np.pi / 16  # of the wave that is pressed in


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize(("omega", "cycles"), [(3.0, 6), (30.0, 24)])
def test_a_small_oscillation_in_full_contact_shows_the_complex_modulus(name, omega, cycles):
    """F_x = X rms(z')^2 (G*/G - 1), at second order; motion of 0.03 samples."""
    expected = (complex_modulus(MATERIALS[name], omega) - 1.0) * 0.5 * Q**2
    refinements = (4, 8)[: size(2, 1)]
    errors = [
        abs(response(MATERIALS[name], omega, m, cycles) / expected - 1.0) for m in refinements
    ]
    assert errors[0] < 5e-3
    # With a dashpot beside branches the order is lower where one of them is a few steps long.
    fall = 0.6 if name == "damped" else 0.35
    assert errors[-1] < size(fall, 1.1) * errors[0]


def test_stress_relaxes_as_the_modulus_at_second_order():
    """At constant indentation from the first moment on: F = mean(d - z) G(t)."""
    refinements = np.array([2, 4, 8, 16])
    errors = []
    for m in refinements:
        line = a_line(8, 0.7, m, 1)
        scene = a_scene((Hold(5.0),), PRONY, m, start="fresh", indentation=20.0)
        times = trace_stamps(scene, m)["time"]
        force = run_scene(line, scene)["trace_normal_force"]
        expected = (20.0 - (line.z.mean() + line.datum)) * relaxation_modulus(PRONY, times)
        errors.append(np.abs(force / expected - 1.0).max(keepdims=True))
    assert observed_order(refinements, np.array(errors)) > 1.8
    assert errors[-1] < 1e-3


@pytest.mark.parametrize("spectrum", [SOLID, PRONY], ids=str)
@pytest.mark.parametrize("duration", [0.01, 0.3, 20.0])
def test_creep_under_a_load_is_exact(spectrum, duration):
    """All elements carry alike: d = F J(t), whatever the steps."""
    line = Line.from_samples(np.zeros(8), np.zeros(8), 1)
    form = retardation(spectrum)
    scene = a_scene((Hold(duration),), spectrum, 1, start="fresh", asked=("state",))
    crept = form.glass - np.sum(form.compliances * np.expm1(-duration / form.times))
    assert float(run_scene(line, scene)["state_d"]) == pytest.approx(0.3 * crept, rel=1e-12)


@pytest.mark.parametrize("name", ["kelvin", "solid"])
def test_a_hold_of_ages_ends_relaxed(name):
    line = a_line()
    held = trace(line, (Slide(0.5, 3.3), Hold(1e9)), MATERIALS[name])
    rest = trace(line, (Slide(0.5, 3.3),), MATERIALS[name], start="relaxed")
    assert held["trace_indentation"][-1] == pytest.approx(rest["trace_indentation"][0], rel=1e-2)
    assert abs(held["trace_mu"][-1]) < 1e-2 * abs(held["trace_mu"][0])
    assert held["trace_mu"].size < 600


@pytest.mark.parametrize("name", MATERIALS)
def test_an_indentation_that_lifts_off_and_returns(name):
    """Friction is not a number where nothing touches, and after ages nothing is remembered."""
    line = a_line()
    history = ((0.0, 4.0, 5.0, 1e6, 1e6 + 1.0), (1.0, 1.0, -9.0, -9.0, 1.0))
    programme = (Slide(0.5, 2.0), Hold(1e6 - 3.0), Slide(0.5, 2.0))
    found = trace(line, programme, MATERIALS[name], indentation=history)
    touching = found["trace_contact_fraction"] > 0.0
    np.testing.assert_array_equal(np.isfinite(found["trace_mu"]), touching)
    np.testing.assert_array_equal(found["trace_normal_force"] > 0.0, touching)
    assert touching[0]
    assert touching[-1]
    assert not touching.all()
    if name == "kelvin":
        return
    # The same from a start at which nothing has ever touched.
    late = ((0.0, 1.0, 2.0, 9.0), (-9.0, -9.0, 1.0, 1.0))
    again = trace(
        line, (Hold(1.0), Slide(0.5, 2.0)), MATERIALS[name], indentation=late, start="relaxed"
    )
    assert again["trace_normal_force"][-1] == pytest.approx(
        found["trace_normal_force"][-1], rel=1e-2
    )


def test_a_reversal_within_a_contact_turns_friction_round():
    """By the time the line has gone back by the size of a contact, and not at once."""
    found = trace(a_line(), (Slide(0.5, 10.25), Slide(-0.5, 30.0)), SOLID)
    mu = found["trace_mu"]
    assert mu[-1] < 0.0 < mu[0]
    assert np.isfinite(mu).all()
    back = trace(a_line(), (Slide(-0.5, 1.0),), SOLID)
    assert mu[-1] == pytest.approx(back["trace_mu"][0], rel=1e-2)


RECORDERS = ("trace", "ledger", "lengths", "film")


class WithoutRecorders(ast.NodeTransformer):
    """Take out of ``follow`` all that has to do with recorders, and the decorator."""

    def visit_FunctionDef(self, node):
        node.decorator_list = []
        return self.generic_visit(node)

    def visit_If(self, node):
        names = {n.id for n in ast.walk(node.test) if isinstance(n, ast.Name)}
        return None if names & set(RECORDERS) else self.generic_visit(node)

    def visit_Expr(self, node):
        called = getattr(getattr(node.value, "func", None), "id", "")
        return None if called == "_keep" else node


def instructions(function, arguments):
    """Return how many machine instructions a function has for arguments of these types."""
    compiled = numba.njit(**FLAGS)(function)
    compiled(*arguments)
    (assembly,) = compiled.inspect_asm().values()
    lines = [line for line in assembly.splitlines() if line.startswith("\t")]
    return sum(not line.startswith("\t.") for line in lines)


@pytest.mark.exhaustive
@pytest.mark.skipif(PLAIN_PYTHON, reason="there is no machine code")
def test_recorders_that_are_off_leave_nothing_in_the_machine_code():
    function = follow.py_func
    tree = WithoutRecorders().visit(ast.parse(textwrap.dedent(inspect.getsource(function))))
    assert not set(RECORDERS) & {
        n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)
    }
    names = dict(function.__globals__)
    exec(compile(ast.fix_missing_locations(tree), "<stripped>", "exec"), names)
    line = a_line(10)
    form, control = FORMS["exponential"](SOLID), ConstantForce(0.3 * line.z.size)
    (track,) = tracks(line.z, line.slope, 4, steps_of((Slide(1.0, 1.0),), 4), 0.0)
    elements = relaxed(form, line.z, control.load, np.nan)
    none = np.arange(0)
    arguments = (form, control, track, elements, 0, none, none, None, None, None, None)
    stripped = instructions(names["follow"], arguments)
    assert instructions(function, arguments) <= 1.02 * stripped
    trace = Trace(*np.empty((5, 0)))
    assert instructions(function, (*arguments[:7], trace, *arguments[8:])) > 1.05 * stripped
