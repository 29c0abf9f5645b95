"""In which line of its file a key stands."""

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.read import key_of, known_studies, line_of
from tests.support.small import TEXT, small_study

FIG7 = known_studies()["fig7"].read_text()
STEPS = known_studies()["velocity_steps"].read_text()


def at(text: str, line: int | None) -> str:
    """Return a line of a text, by its number from 1."""
    return text.splitlines()[line - 1] if line else ""


@pytest.mark.parametrize(
    ("key", "scale", "line"),
    [
        ("grid.velocity", "", "velocity = {geomspace = [1e-4, 1e-1, 8]}       # m/s"),
        ("grid.velocity.geomspace[2]", "paper", "velocity = {geomspace = [1e-4, 1e-1, 20]}"),
        ("grid.roughness", "paper", "roughness = 1e-5                               # m"),
        ("grid.missing", "paper", "[grid]"),
        ("compare.paper_step.steps_per_spacing", "", "steps_per_spacing = 1"),
        ("scales.paper.study.realizations", "", "realizations = 200"),
        ("gird.hurst", "", ""),
    ],
)
def test_a_key_is_found_where_it_is_in_force(key, scale, line):
    assert at(FIG7, line_of(FIG7, key, scale)) == line


def test_segments_of_a_programme_are_counted():
    lines = [line_of(STEPS, f"scene.programme[{k}].slide.velocity") for k in (0, 1, 11)]
    assert [at(STEPS, line) for line in lines] == [
        "slide = {ratio = 1.0, distance = 1e-3}",
        "slide = {ratio = 1.2, distance = 5e-3}",
        "slide = {ratio = 0.1, distance = 5e-3}",
    ]


@pytest.mark.parametrize(
    ("message", "key"),
    [
        ("grid.velocity.linspace[2] = 20000: must be", "grid.velocity.linspace[2]"),
        ("grid: 200000000 points", "grid"),
        ("scene.programme[0] holds jump: must hold", "scene.programme[0]"),
        ("--set grid.hurst: use table.key=value", ""),
    ],
)
def test_the_key_of_a_message(message, key):
    assert key_of(message) == key


@pytest.mark.parametrize(
    ("setting", "placed"), [("grid.velocity=[0.1]", True), ("grid.hurst=2", False)]
)
def test_a_value_of_the_command_line_stands_in_no_line(setting, placed):
    text = TEXT.replace("hurst = [0.3, 0.7]", "hurst = 1.2")
    with pytest.raises(UserError) as caught:
        small_study(setting, text=text)
    line = text.splitlines().index("hurst = 1.2") + 1
    assert caught.value.place.endswith(f"small.toml, line {line})") == placed
