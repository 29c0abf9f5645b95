"""Every mistake in a study is answered with one line: the key, its value, what would be right."""

import pytest

from tests.support.small import TEXT, small_study, write_study
from workflow.errors import UserError
from workflow.study.read import find_study, read_study


def complaint(*settings, **how):
    """Return the message the small study with ``settings`` is refused with."""
    with pytest.raises(UserError) as error:
        small_study(*settings, **how)
    message = str(error.value)
    assert "\n" not in message
    return message


TYPOS = {
    "study.sead": "title, seed, realizations",
    "material.shear_modulos": "shear_modulus, relaxation_time",
    "surface.lenght": "length, normalisation",
    "grid.hurts": "hurst, normal_force",
    "scene.quantity": "quantities, indentation_rate",
    "numerics.schema": "scheme, steps_per_spacing",
    "compare.coarse.schema": "scheme, steps_per_spacing",
    "gird.hurst": "study, material, surface, grid",
}


@pytest.mark.parametrize("key", TYPOS)
def test_typo_in_a_key_names_it_and_the_known_ones(key):
    message = complaint(f"{key}=1")
    assert message.startswith(key if not key.startswith("gird") else "gird: unknown")
    assert "unknown key; known are" in message
    assert TYPOS[key] in message


BAD_VALUES = [
    ("grid.normal_force=-1.0", "-1.0", "greater than zero"),
    ("grid.normal_force=[1.0, 0.0]", "0.0", "greater than zero"),
    ("grid.hurst=1.2", "1.2", "between 0 and 1"),
    ("grid.hurst=-0.1", "-0.1", "between 0 and 1"),
    ("grid.spacing=3e-5", "3e-05", "must divide surface.length = 0.01"),
    ("grid.spacing=0.005", "0.005", "at least 4 elements"),
    ("grid.roughness=0", "0.0", "greater than zero"),
    ("grid.velocity=nan", "nan", "finite number"),
    ("grid.velocity=inf", "inf", "finite number"),
    ("grid.velocity=true", "True", "finite number"),
    ("grid.velocity=fast", "'fast'", "finite number"),
    ("grid.velocity=[]", "[]", "at least one value"),
    ("grid.velocity=[0.1, 0.1]", "[0.1, 0.1]", "twice"),
    ("grid.velocity_step=-1", "-1.0", "greater than -1"),
    ("grid.velocity_step=-3", "-3.0", "greater than -1"),
    ("material.shear_modulus=-1e7", "-10000000.0", "greater than zero"),
    ("material.relaxation_time=inf", "inf", "finite number"),
    ("material.relaxation_time=[1e-3]", "[0.001]", "finite number"),
    ("surface.length=0", "0", "greater than zero"),
    ("surface.normalisation=rms", "'rms'", "one of modal, integral"),
    ("surface.snap_spacing=1", "1", "true or false"),
    ("study.seed=-1", "-1", "whole number, at least 0"),
    ("study.seed=1.5", "1.5", "whole number"),
    ("study.realizations=1", "1", "whole number, at least 2"),
    ("study.realizations=true", "True", "whole number"),
    ("study.realizations_per_block=3", "3", "must divide realizations = 4"),
    ("study.realizations_per_block=4", "4", "at least 2 blocks"),
    ("scene.quantities=steady", "'steady'", "must be a list"),
    ("scene.quantities=[]", "[]", "must be a list"),
    ('scene.quantities=["stedy"]', "'stedy'", "one of steady, jump, relaxation"),
    ('scene.quantities=["models"]', "['models']", 'needs "relaxation" too'),
    ("scene.quantities=[1]", "1", "one of steady"),
    ("scene.indentation_rate=no", "'no'", "true or false"),
    ("numerics.scheme=rk4", "'rk4'", "one of implicit-euler, exponential"),
    ("numerics.scheme=[1]", "[1]", "one of implicit-euler"),
    ("numerics.steps_per_spacing=0", "0", "whole number, at least 1"),
    ("numerics.steps_per_spacing=automatic", "'automatic'", "whole number"),
    ("numerics.samples=7", "7", "whole number, from 8"),
    ("numerics.horizon=0.5", "0.5", "between 1 and 100"),
    ("numerics.horizon=nan", "nan", "finite number"),
    ("compare.coarse.horizon=1000", "1000.0", "between 1 and 100"),
    ("compare.coarse=1", "1", "must be a table"),
    ("compare=1", "1", "must be a table"),
    ("grid=3", "3", "must be a table"),
]


@pytest.mark.parametrize(("setting", "value", "remedy"), BAD_VALUES)
def test_bad_value_names_key_value_and_remedy(setting, value, remedy):
    message = complaint(setting)
    key = setting.partition("=")[0]
    assert message.startswith(key)
    assert f" = {value}:" in message
    assert remedy in message


REQUIRED = {
    "study.realizations": "realizations = 4",
    "material.shear_modulus": "shear_modulus = 1e7",
    "material.relaxation_time": "relaxation_time = 1e-3",
    "surface.length": "length = 0.01",
    "grid.hurst": "hurst = [0.3, 0.7]",
    "grid.normal_force": "normal_force = [0.04, 0.4]\n",
    "grid.spacing": "spacing = 1e-4",
    "grid.roughness": "roughness = 1e-5",
    "grid.velocity": "velocity = [0.03, 0.1]",
    "grid.velocity_step": "velocity_step = 0.2",
}


@pytest.mark.parametrize("key", REQUIRED)
def test_missing_key_is_named(key):
    assert TEXT.count(REQUIRED[key]) == 1
    assert complaint(text=TEXT.replace(REQUIRED[key], "\n")) == f"{key}: missing"


def test_the_nearest_spacing_proposed_is_accepted():
    message = complaint("grid.spacing=3e-5")
    nearest = message.partition("nearest: ")[2].partition(";")[0]
    assert small_study(f"grid.spacing={nearest}").elements(float(nearest)) == 333


def test_unknown_scale_names_the_known_ones():
    assert complaint(scale="wiede") == "--scale wiede: the study knows wide"


def test_scale_of_a_study_without_any():
    text = TEXT.partition("[scales")[0]
    assert complaint(text=text, scale="smoke") == "--scale smoke: the study knows none"


def test_scale_that_is_no_table():
    text = TEXT.partition("[scales")[0] + "[scales]\nwide = 3\n"
    assert complaint(text=text, scale="wide") == "scales.wide = 3: must be a table"


def test_scales_that_are_no_table():
    assert "scales" in complaint(text=f"scales = 3\n{TEXT.partition('[scales')[0]}", scale="wide")


def test_a_date_as_title_is_refused():
    assert complaint("study.title=2014-07-24").startswith("study.title")


@pytest.mark.parametrize(
    ("setting", "extreme"), [("grid.spacing", "5e-324"), ("surface.length", "1e306")]
)
def test_a_line_of_more_elements_than_any_float_is_refused(setting, extreme):
    assert "grid.spacing" in complaint(f"{setting}={extreme}")


def test_a_comparison_without_a_name_does_not_replace_the_study():
    text = TEXT.replace("[compare.coarse]", '[compare.""]')
    try:
        study = small_study(text=text)
    except UserError:
        return
    assert study.variants[""].scheme == "exponential"


@pytest.mark.parametrize("setting", ["grid.hurst", "=3", "grid.=3", "grid hurst=1"])
def test_setting_that_is_no_setting(setting):
    assert complaint(setting) == f"--set {setting}: use table.key=value"


def test_unknown_name_lists_the_known_studies():
    with pytest.raises(UserError, match=r"^study 'fig77': not among .*fig7"):
        find_study("fig77")


def test_missing_file_is_named(tmp_path):
    with pytest.raises(UserError, match=r"nowhere\.toml': no such file$"):
        find_study(str(tmp_path / "nowhere.toml"))


def test_a_folder_is_no_study(tmp_path):
    folder = tmp_path / "folder.toml"
    folder.mkdir()
    with pytest.raises(UserError, match=r"folder\.toml': no such file$"):
        find_study(str(folder))


def test_unreadable_file_is_named(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    path = write_study(tmp_path)
    monkeypatch.setattr("pathlib.Path.read_text", refuse)
    with pytest.raises(UserError, match=r"small\.toml: cannot be read.*Permission denied"):
        read_study(path)


@pytest.mark.parametrize("content", [b"[study\n", b"\xff\xfe[study]", b"a = 1\na = 2", b"\x00"])
def test_what_is_not_toml_is_named(tmp_path, content):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(UserError, match=r"bad\.toml: cannot be read as TOML") as error:
        read_study(str(path))
    assert "\n" not in str(error.value)
