"""Every mistake in a study is answered with one line: the key, its value, what would be right."""

import pytest

from tests.support.small import TEXT, complaint, small_study, write_study
from workflow.errors import UserError
from workflow.study.read import find_study, read_study

# Beside those of docs/limits.md, which test_limits.py tries.
BAD_VALUES = [
    ("grid.normal_force=[1.0, 0.0]", "0.0", "greater than zero"),
    ("grid.hurst=-0.1", "-0.1", "between 0 and 1"),
    ("grid.spacing=0.005", "0.005", "at least 4 elements"),
    ("grid.roughness=0", "0.0", "greater than zero"),
    ("grid.velocity_step=-3", "-3.0", "greater than -1"),
    ("material.shear_modulus=-1e7", "-10000000.0", "greater than zero"),
    ("material.relaxation_time=inf", "inf", "finite number"),
    ("material.relaxation_time=[1e-3]", "[0.001]", "finite number"),
    ("study.seed=-1", "-1", "whole number, at least 0"),
    ("study.seed=1.5", "1.5", "whole number"),
    ("study.realizations=true", "True", "whole number"),
    ("study.realizations_per_block=4", "4", "at least 2 blocks"),
    ("scene.quantities=[]", "[]", "must be a list"),
    ('scene.quantities=["stedy"]', "'stedy'", "one of steady, jump, relaxation"),
    ("scene.quantities=[1]", "1", "one of steady"),
    ("scene.indentation_rate=no", "'no'", "true or false"),
    ("numerics.scheme=[1]", "[1]", "one of implicit-euler"),
    ("numerics.steps_per_spacing=automatic", "'automatic'", "whole number"),
    ("numerics.horizon=nan", "nan", "finite number"),
    ("numerics.accuracy=0", "0.0", "between 0.0001 and 0.3"),
    ("numerics.accuracy=1", "1.0", "between 0.0001 and 0.3"),
    ('numerics.accuracy="high"', "'high'", "finite number"),
    ("numerics.max_realizations=0", "0", "whole number"),
    ("compare.coarse.horizon=1000", "1000.0", "between 1 and 100"),
    ("compare.coarse.accuracy=-1", "-1.0", "between 0.0001 and 0.3"),
    ("cluster.jobs=0", "0", "at least 1"),
    ("cluster.cores=1.5", "1.5", "whole number"),
    ("cluster.memory=4", "4", "string"),
    ("cluster.patience=-1", "-1", "greater than zero"),
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


def test_the_nearest_spacing_proposed_is_accepted():
    message = complaint("grid.spacing=3e-5")
    nearest = message.partition("nearest: ")[2].partition(";")[0]
    assert small_study(f"grid.spacing={nearest}").elements(float(nearest)) == 333


def test_scale_of_a_study_without_any():
    text = TEXT.partition("[scales")[0]
    assert complaint(text=text, scale="smoke") == "--scale smoke: the study knows none"


def test_scale_that_is_no_table():
    text = TEXT.partition("[scales")[0] + "[scales]\nwide = 3\n"
    assert complaint(text=text, scale="wide") == "scales.wide = 3: must be a table"


def test_scales_that_are_no_table():
    assert "scales" in complaint(text=f"scales = 3\n{TEXT.partition('[scales')[0]}", scale="wide")


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


@pytest.mark.parametrize("setting", ["grid.=3", "grid hurst=1"])
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
