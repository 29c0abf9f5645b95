"""The panel "my rubber" of the page: the same numbers as the kinetic law in Python."""

import json
from urllib.parse import unquote

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.kernels import Wlf
from elastomer_friction.workflow.kinetic_law import KineticLaw
from elastomer_friction.workflow.report.explore import explorer_page
from elastomer_friction.workflow.report.my_rubber import scaled_friction
from elastomer_friction.workflow.result.netcdf import open_tree, write_datasets
from tests.support.browser import in_a_browser, told_by
from tests.support.synthetic import add, result

FORCES = [0.1, 1.0, 10.0]
SCALES = {"shear_modulus": 3.0, "roughness": 0.5, "tau": 0.01, "q_max": 0.2}
STEPS = [(0.001, 0.0012), (0.0017, 0.09), (0.09, 0.0003)]  # at the speeds of the result


def computed():
    """Return a result with friction that depends on load, H and speed."""
    data = result(normal_force=FORCES).assign_attrs(body="foundation")
    data = data.assign_coords(q_max=("spacing", np.pi / data.spacing.values))
    x = data.speed_ratio
    friction = 0.03 * x / (x + 3.0) * data.normal_force**-0.2 * (1.0 + data.hurst)
    return add(data, 0.03, mu_1=friction)


def scaled(data):
    """Return a result of other G, h, tau, q_max with the same friction without dimensions."""
    g, h, tau, q = SCALES.values()
    factors = {"shear_modulus": g, "tau": tau, "q_max": q, "length": 1.0 / q}
    factors |= {"roughness": h, "velocity": 1.0 / (tau * q), "normal_force": g * h / q}
    factors |= {"rms_slope": h * q, "mu_1": h * q}
    return data.assign({name: data[name].variable * factor for name, factor in factors.items()})


@pytest.fixture(scope="module")
def data():
    """Return a result of two H, three loads and seven velocities."""
    return computed()


@pytest.fixture(scope="module")
def page(data, tmp_path_factory):
    """Return the text of its page."""
    path = tmp_path_factory.mktemp("rubber") / "fig7.nc"
    write_datasets(path, {"": data})
    return explorer_page(open_tree(path), path.name)


def in_browser(page, folder, script, width=1280):
    """Return the object ``told`` of a script that runs in a page."""
    told = f"<script>setTimeout(() => {{ const told = {{}}; {script}\n"
    told += (
        "document.body.dataset.told = encodeURIComponent(JSON.stringify(told)); }, 300);</script>"
    )
    path = folder / "page.html"
    path.write_text(page.replace("</body>", f"{told}</body>"), encoding="utf-8")
    (left,) = told_by(path, folder / "profile", "told", width=width)
    return json.loads(unquote(left))


def laws(dataset):
    """Return the laws in Python at all loads and H."""
    return [
        KineticLaw.from_result(dataset, {"hurst": hurst, "normal_force": force})
        for hurst in dataset.hurst.values
        for force in dataset.normal_force.values
    ]


def numbers(law, v1, v2):
    """Return friction, jump, relaxation time and late friction of a step by a law."""
    late = law.after_jump(v1, v2, float(law.relaxation_times(v2)))
    return [law.steady(v1), law.jump(v1, v2), law.relaxation_times(v2), late]


ASK = """
const [computed] = held.rubber.rubbers;
const ask = (rubber, steps) => steps.map(([v1, v2]) => {
  const law = lawOfRubber(rubber, computed), time = law.relaxationTime(v2);
  return [law.steady(v1), law.jump(v1, v2), time, law.afterJump(v1, v2, time), law.fastest];
});
"""


@in_a_browser
@pytest.mark.filterwarnings(
    "ignore::elastomer_friction.workflow.kinetic_law.BeyondKineticLawWarning"
)
def test_the_page_and_python_have_one_law(data, page, tmp_path):
    other = scaled(data)
    asked, expected = [], []
    for dataset in (data, other):
        speed = float(dataset.velocity[0] / data.velocity[0])
        steps = [(v1 * speed, v2 * speed) for v1, v2 in STEPS]
        for law, curve in zip(laws(dataset), one_rubber(data)["curves"], strict=True):
            names = ("shear_modulus", "tau", "roughness", "q_max")
            rubber = {name: float(dataset[name].item()) for name in names}
            pressing = 4.0 * curve["load"] * rubber["shear_modulus"] * rubber["roughness"]
            rubber |= {"pressing": pressing, "hurst": curve["hurst"], "family": curve["family"]}
            asked.append([rubber, steps])
            expected.append([[*numbers(law, *step), law.fastest] for step in steps])
    script = f"{ASK} told.found = {json.dumps(asked)}.map(([r, s]) => ask(r, s));"
    actual = in_browser(page, tmp_path, script)["found"]
    np.testing.assert_allclose(actual, np.array(expected, dtype=float), rtol=1e-9)


@in_a_browser
def test_between_loads_friction_is_their_power_law_and_beyond_them_refused(page, tmp_path):
    script = """
const [computed] = held.rubber.rubbers, {own, curves} = computed;
const pressed = (f) =>
  lawOfRubber({...own, family: curves[0].family, pressing: own.pressing * f}, computed);
told.friction = [1, 3, 10].map((f) => pressed(f).friction[3]);
told.refused = [0.99, 101].map((f) => pressed(f).refused);
const say = (id, value) => {
  $(id).value = value;
  $(id).dispatchEvent(new Event("input"));
  return $("my-said").textContent;
};
told.said = say("my-v2", 215);
told.fast = say("my-v1", 400);
told.away = $("my-curves").hidden;
say("my-v1", 200);
told.cold = say("my-heat", 0);
say("my-heat", 40);
told.small = say("my-pressing", 300);
told.steep = say("my-roughness", 400);
told.weak = say("my-pressing", 0);
const wide = document.documentElement;
told.fits = wide.scrollWidth <= wide.clientWidth;
told.keys = [...document.querySelectorAll("section :is(input, select)")]
  .filter((each) => !each.closest("[hidden]")).every((each) => {
  each.focus(); return document.activeElement === each; });
"""
    told = in_browser(page, tmp_path, script, width=500)
    one, between, ten = told["friction"]
    assert between == pytest.approx(one * 3.0**-0.2)
    assert ten == pytest.approx(one * 10.0**-0.2)
    assert all("Outside what was computed" in message for message in told["refused"])
    assert "standard error is 3 %" in told["said"]
    assert "Outside what was computed: for this τ" in told["fast"]
    assert "Outside what was computed: for this τ" in told["cold"]
    assert "slopes are not small" not in told["small"]
    assert "The rms slope is 2: above 0.3 slopes are not small, and the model" in told["steep"]
    assert "take F_N/L from" in told["weak"]
    assert (told["away"], told["fits"], told["keys"]) == (True, True, True)


RUBBER = {"shear_modulus": 1e7, "branches": [[6e7, 2e-4], [4e7, 2e-3]]}
SHIFT = {"wlf": {"c1": 8.0, "c2": 100.0, "reference": 20.0}}


def with_branches(data):
    """Return the result for a rubber with branches and a shift, at both temperatures."""
    temperatures, study = [20.0, 30.0], json.loads(data.attrs["study"])
    study["material"] = {**RUBBER, **SHIFT, "temperature": temperatures}
    law = Wlf(**SHIFT["wlf"])
    tau = [float(data.tau) * 10.0 ** law.decades(each) for each in temperatures]
    at = xr.DataArray(tau, {"temperature": temperatures}, "temperature")
    data = data.drop_vars("tau").assign(
        mu_1=data.mu_1.expand_dims(temperature=at.temperature, axis=-1)
    )
    return data.assign_coords(tau=at).assign_attrs(study=json.dumps(study))


def one_rubber(data):
    """Return the only rubber of a result."""
    (actual,) = scaled_friction({"": data})["rubbers"]
    return actual


@in_a_browser
def test_of_branches_the_page_has_steady_friction_at_every_temperature(data, tmp_path):
    rubber, cold = with_branches(data), 12.0
    path = tmp_path / "branches.nc"
    write_datasets(path, {"": rubber})
    script = f"""
const [computed] = held.rubber.rubbers, {{own, curves, temperature}} = computed;
const k = temperature.degrees.indexOf({cold}), tau = own.tau * temperature.factors[k];
const law = lawOfRubber({{...own, tau, family: curves[0].family}}, computed);
told.found = law.velocity.map(law.steady);
told.velocity = law.velocity;
told.laws = [law.jump, law.afterJump].map((each) => each === undefined);
told.said = $("my-said").textContent;
told.hidden = $("my-step").parentElement.hidden && $("my-v2") === null;
"""
    told = in_browser(explorer_page(open_tree(path), path.name), tmp_path, script)
    # At another temperature it is the same friction at a speed a_T times less.
    slower = Wlf(**SHIFT["wlf"]).decades(cold)
    own = rubber.isel(temperature=0, spacing=0, roughness=0)
    law = KineticLaw.from_result(own, {"hurst": 0.3, "normal_force": FORCES[0]})
    speeds = np.array(told["velocity"], dtype=float)
    np.testing.assert_allclose(speeds, own.velocity / 10.0**slower, rtol=1e-9)
    np.testing.assert_allclose(told["found"], law.steady(speeds * 10.0**slower), rtol=1e-9)
    assert told["laws"] == [True, True]
    assert told["hidden"]
    assert "µ(t) is not known here, for eqs. 12 to 16 are those of one" in told["said"]
    assert "G₀ = 1.1·10⁸ Pa" in told["said"]  # G is 10⁷ Pa in the result, the branches 10⁸ Pa


@in_a_browser
def test_of_branches_friction_over_time_is_that_which_was_computed(data, tmp_path):
    """All times are half as long; roughness and load are twice as large."""
    rubber = with_branches(data)
    sample = xr.DataArray([0.5, 0.25, 0.0], dims="sample")
    time = xr.DataArray([0.0, 1.0, 3.0], dims="sample") / (1.0 + rubber.speed_ratio)
    rubber = rubber.assign(mu=rubber.mu_1 * (1.0 + sample)).assign_coords(
        time=time + 0 * rubber.mu_1
    )
    path = tmp_path / "branches.nc"
    write_datasets(path, {"": rubber})
    script = """
const [computed] = held.rubber.rubbers, {own, curves} = computed;
const other = {...own, family: curves[0].family, tau: own.tau / 2, roughness: 2 * own.roughness,
  pressing: 2 * own.pressing};
const law = lawOfRubber(other, computed);
Object.assign(told, law.motion(law.velocity[3] * 1.1), {velocity: law.velocity[3]});
told.shown = !$("my-step").parentElement.hidden;
told.said = $("my-said").textContent;
"""
    told = in_browser(explorer_page(open_tree(path), path.name), tmp_path, script)
    first = dict.fromkeys(("hurst", "normal_force", "spacing", "roughness", "velocity_step"), 0)
    at = rubber.isel(first | {"temperature": 0, "velocity": 3})
    assert told["at"] == told["velocity"]
    assert told["velocity"] == pytest.approx(2.0 * float(at.velocity), rel=1e-9)
    np.testing.assert_allclose(told["friction"], 2.0 * at.mu.values, rtol=1e-9)
    np.testing.assert_allclose(told["time"], at.time.values * float(at.tau) / 2.0, rtol=1e-9)
    assert told["shown"]
    assert "µ(t) is the motion computed at" in told["said"]


@pytest.mark.parametrize(
    ("slopes", "hurst"), [((7.4, 0.25), 0.7), ((0.1, 0.02), 0.3), ((7, 3), 0.7)]
)
def test_the_rubber_shown_first_has_the_steepest_slope_that_is_small(data, slopes, hurst):
    steep = data.rms_slope * 0 + xr.DataArray(list(slopes), {"hurst": data.hurst}, "hurst")
    actual = one_rubber(data.assign(rms_slope=steep))
    assert actual["own"]["hurst"] == hurst
    assert actual["own"]["family"] == actual["curves"][0]["family"]


def test_measured_lines_are_scaled_without_the_kinetic_law(data):
    lines = one_rubber(data.isel(hurst=[0]).assign_coords(hurst=[np.nan]))
    assert {curve["hurst"] for curve in lines["curves"]} == {None}
    assert not lines["several"]
    assert "need a Hurst exponent" in lines["without_steps"]


def test_results_that_cannot_be_scaled_have_a_reason(data):
    assert len(one_rubber(data)["curves"]) == 6
    unknown = data.copy(deep=True)
    unknown.mu_1[{"hurst": 0, "normal_force": 0, "velocity": 2}] = np.nan
    assert len(one_rubber(unknown)["curves"]) == 5
    assert scaled_friction({"": data.drop_vars("mu_1")}) is None
    for other, why in [
        (data.assign_attrs(body="half-space"), "are those of the foundation, this is a half-space"),
        (data.drop_vars("rms_slope"), "the result has no rms_slope"),
        (data.isel(velocity=[0]), "it has one velocity, and µ(v) needs two or more"),
        (data.assign(mu_1=data.mu_1.expand_dims("stiffness")), "depends on stiffness as well"),
        (data.assign(mu_1=np.nan * data.mu_1), "is known nowhere at all velocities"),
    ]:
        actual = scaled_friction({"": other})
        assert actual["rubbers"] == []
        assert why in actual["without"][0]


def test_temperatures_are_those_of_the_material(data):
    usual = one_rubber(data)["temperature"]
    assert (usual["degrees"][0], usual["degrees"][-1], usual["own"]) == (-40.0, 100.0, 40)
    rubber = with_branches(data)
    own = one_rubber(rubber)
    assert own["temperature"]["degrees"][own["temperature"]["own"]] == 20.0
    # Between the two that were computed, the factor is what tau says.
    factor = own["temperature"]["factors"][own["temperature"]["degrees"].index(30.0)]
    assert factor == pytest.approx(float(rubber.tau[1] / rubber.tau[0]))
    study = json.loads(rubber.attrs["study"])
    study["material"]["shifts_file"] = "shifts.csv"
    del study["material"]["wlf"]
    actual = one_rubber(rubber.assign_attrs(study=json.dumps(study)))["temperature"]
    assert actual["degrees"] == [20.0, 30.0]
    assert actual["factors"] == pytest.approx([1.0, factor])
