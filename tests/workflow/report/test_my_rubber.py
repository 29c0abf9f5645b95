"""The panel "my rubber" of the page: what it says is what the kinetic law says in Python."""

import json
from urllib.parse import unquote

import numpy as np
import pytest

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
    """Return what a script in a page leaves in ``told``."""
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
    """Return what a law says of a step."""
    late = law.after_jump(v1, v2, float(law.relaxation_times(v2)))
    return [law.steady(v1), law.jump(v1, v2), law.relaxation_times(v2), late]


ASK = """
const {own, curves} = held.rubber;
const ask = (rubber, steps) => steps.map(([v1, v2]) => {
  const law = lawOfRubber(rubber, curves), time = law.relaxationTime(v2);
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
        for law, curve in zip(laws(dataset), scaled_friction(data)["curves"], strict=True):
            names = ("shear_modulus", "tau", "roughness", "q_max")
            rubber = {name: float(dataset[name].item()) for name in names}
            pressing = 4.0 * curve["load"] * rubber["shear_modulus"] * rubber["roughness"]
            rubber |= {"pressing": pressing, "hurst": curve["hurst"], "family": curve["family"]}
            asked.append([rubber, steps])
            expected.append([[*numbers(law, *step), law.fastest] for step in steps])
    script = f"{ASK} told.found = {json.dumps(asked)}.map(([r, s]) => ask(r, s));"
    found = in_browser(page, tmp_path, script)["found"]
    np.testing.assert_allclose(found, np.array(expected, dtype=float), rtol=1e-9)


@in_a_browser
def test_between_loads_friction_is_their_power_law_and_beyond_them_refused(page, tmp_path):
    script = """
const {own, curves} = held.rubber, rubber = {...own, family: curves[0].family};
const pressed = (f) => lawOfRubber({...rubber, pressing: own.pressing * f}, curves);
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
told.cold = say("my-warmer", 0);
told.weak = (say("my-warmer", 114), say("my-pressing", 0));
const wide = document.documentElement;
told.fits = wide.scrollWidth <= wide.clientWidth;
told.keys = [...document.querySelectorAll("section input, section select")].every((each) => {
  each.focus(); return document.activeElement === each; });
"""
    told = in_browser(page, tmp_path, script, width=500)
    one, between, ten = told["friction"]
    assert between == pytest.approx(one * 3.0**-0.2)
    assert ten == pytest.approx(one * 10.0**-0.2)
    assert all("Outside what was computed" in said for said in told["refused"])
    assert "standard error 3 %" in told["said"]
    assert "Outside what was computed: for this τ" in told["fast"]
    assert "Outside what was computed: for this τ" in told["cold"]
    assert "take F_N/L from" in told["weak"]
    assert (told["away"], told["fits"], told["keys"]) == (True, True, True)


def test_only_the_papers_element_on_a_foundation_is_scaled(data):
    assert len(scaled_friction(data)["curves"]) == 6
    assert scaled_friction(data.assign_attrs(body="half-space")) is None
    assert scaled_friction(data.drop_vars("mu_1")) is None
    assert scaled_friction(data.isel(velocity=[0])) is None
    study = json.loads(data.attrs["study"])
    study["material"]["temperature"] = 20
    assert scaled_friction(data.assign_attrs(study=json.dumps(study))) is None
    unknown = data.copy(deep=True)
    unknown.mu_1[{"hurst": 0, "normal_force": 0, "velocity": 2}] = np.nan
    assert len(scaled_friction(unknown)["curves"]) == 5
