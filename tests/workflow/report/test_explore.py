"""The explorer page of a result: its numbers, and its controls in a browser."""

import json
import re

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.report.explore import explorer_page
from elastomer_friction.workflow.result.netcdf import open_tree, write_datasets
from tests.support.browser import in_a_browser, told_by
from tests.support.commands import output, refusal
from tests.support.synthetic import add, result, with_rates


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """Return a result of two H, F_N and dx and seven velocities, with a rate that is not known."""
    data = result(spacing=[1e-6, 2e-6]).set_coords("speed_ratio")
    data = with_rates(data, data.speed_ratio**0.5, relative_error=0.1)
    first = dict.fromkeys(("hurst", "normal_force", "spacing", "velocity"), 0)
    data.relaxation_rate[first] = np.nan
    data.fit_status[first] = 2
    data.fit_status.attrs = {
        "long_name": "outcome of the fit of eq. 6",
        "flag_values": np.array([-1, 0, 1, 2, 3, 4, 5, 6], np.int8),
        "flag_meanings": "failed fitted a b c d e f",
    }
    data["mu"] = data.speed_ratio * xr.DataArray([1.2, 1.1, 1.0], dims="sample")
    data = data.assign_coords(
        sample=[0, 1, 2], time=data.speed_ratio * xr.DataArray([0.0, 1.0, 2.0], dims="sample")
    )
    path = tmp_path_factory.mktemp("explored") / "fig7.nc"
    write_datasets(path, {"": data, "coarse": add(data.copy(), relaxation_rate=1.0)})
    return path


@pytest.fixture(scope="module")
def page(file):
    """Return the text of its page."""
    return explorer_page(open_tree(file), file.name)


def held_by(page):
    """Return the data in a page."""
    (text,) = re.findall(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
    return json.loads(text)


def test_the_numbers_of_the_page_are_those_of_the_result(file, page):
    held = held_by(page)
    tree = open_tree(file)
    for group, variables in held["groups"].items():
        data = tree[group or "/"].to_dataset()
        assert variables.keys() >= {"relaxation_rate", "relaxation_rate_error", "mu", "time"}
        for name, variable in variables.items():
            assert variable["dims"] == list(data[name].dims)
            actual = np.array(variable["values"], dtype=float).reshape(variable["shape"])
            np.testing.assert_allclose(actual, data[name].values, rtol=1e-5)
    assert [axis["values"] for axis in held["axes"]] == [
        pytest.approx(tree[axis["name"]].values) for axis in held["axes"]
    ]


def test_every_variable_has_its_role(page):
    held = held_by(page)["groups"][""]
    roles = {"relaxation_rate": "estimate", "relaxation_rate_error": "error", "fit_status": "flag"}
    assert {name: held[name]["role"] for name in roles} == roles
    assert held["speed_ratio"]["role"] == held["time"]["role"] == "abscissa"


def test_the_page_loads_nothing(page):
    assert not re.findall(r"(?:src|href)=|@import|url\((?!#clip)|fetch\(|import\s*\(", page)
    assert page.count("<script") == 2


def test_a_title_is_text_on_the_page(file):
    tree = open_tree(file)
    tree.attrs["title"] = "</script><b>"
    assert "<b>" not in explorer_page(tree, "<b>.nc")


def test_the_command_writes_the_page_and_refuses_in_a_line(file, capsys, tmp_path):
    out = tmp_path / "new" / "page.html"
    assert output(capsys, "explore", str(file), "--out", str(out)) == f"{out}\n"
    assert "</html>" in out.read_text(encoding="utf-8")
    message = refusal(capsys, "explore", str(file), "--out", str(file))
    assert message == f"error: --out {file}: is the result itself; name another file\n"
    message = refusal(capsys, "explore", str(tmp_path / "no.nc"))
    assert message == f"error: {tmp_path / 'no.nc'}: not found\n"


def test_a_result_of_one_point_has_nothing_to_explore(capsys, tmp_path):
    one = {axis: values[:1] for axis, values in result().coords.items() if values.ndim}
    data = add(result(**{axis: values.values for axis, values in one.items()}), mu_1=0.1)
    write_datasets(tmp_path / "one.nc", {"": data})
    message = refusal(capsys, "explore", str(tmp_path / "one.nc"))
    assert "one.nc: holds nothing that varies" in message


CONTROLS = """
<script>
addEventListener("load", () => setTimeout(() => {
  const told = [], get = (id) => document.getElementById(id), plot = get("plot");
  const points = () => plot.querySelectorAll(".point").length;
  const key = (name) =>
    plot.dispatchEvent(new KeyboardEvent("keydown", {key: name, bubbles: true}));
  told.push(points());
  get("values").querySelector("input").click(); told.push(points());
  get("values").querySelector("input").click(); told.push(points());
  const slider = document.querySelector("#sliders input");
  slider.value = 1; slider.dispatchEvent(new Event("input")); told.push(points());
  get("comparisons").querySelectorAll("input")[1].click(); told.push(points());
  key("ArrowRight"); key("ArrowRight"); told.push(get("tip").textContent.replaceAll("\\n", "; "));
  key("+"); told.push(plot.getAttribute("aria-label").match(/(\\d+) points/)[1]);
  key("0"); told.push(plot.getAttribute("aria-label").match(/(\\d+) points/)[1]);
  get("y").value = "mu"; get("y").dispatchEvent(new Event("change"));
  told.push(get("x").value, document.querySelectorAll("#sliders input").length);
  const page = document.documentElement, within = page.scrollWidth <= page.clientWidth;
  told.push(within ? "fits" : "sticks out");
  const focusable = [...document.querySelectorAll("select, input, button, summary, #plot")];
  told.push(focusable.every((each) => { each.focus(); return document.activeElement === each; }));
  document.body.dataset.told = told.join("|");
}, 500));
</script>"""


@in_a_browser
@pytest.mark.parametrize("width", [1280, 500])
def test_controls_in_a_browser(page, tmp_path, width):
    path = tmp_path / "page.html"
    path.write_text(page.replace("</main>", f"</main>{CONTROLS}"), encoding="utf-8")
    (told,) = told_by(path, tmp_path / "profile", "told", width=width)
    first, without, again, slid, alone, tip, zoomed, whole, x, sliders, fits, keys = told.split("|")
    # Seven velocities, two forces or H in colours, the study and its comparison; one is not known.
    assert (int(first), int(without), int(again)) == (27, 14, 27)
    assert int(slid) in (27, 28)
    assert int(alone) in (13, 14)
    assert re.match(r"b = [\d.·⁻⁰-⁹]+ ± [\d.·⁻⁰-⁹]+; ", tip)
    assert "outcome of the fit of eq. 6: fitted" in tip
    assert int(zoomed) < int(whole) == int(alone)
    assert x == "time"
    assert int(sliders) == 3  # of four axes one is in colours
    assert (fits, keys) == ("fits", "true")
