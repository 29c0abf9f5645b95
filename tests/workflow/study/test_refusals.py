"""Every mistake in a study is answered with one line: the key, its value, what would be right."""

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.errors import UserError, UserErrors
from elastomer_friction.workflow.study.grid import AXES
from elastomer_friction.workflow.study.read import find_study, read_study
from elastomer_friction.workflow.study.tables import TABLES
from elastomer_friction.workflow.study.variants import COMPARE
from tests.support.documents import without
from tests.support.small import TEXT, complaint, small_study, write_study

# Beside those of tests/refusals.md (test_limits.py), and a wrong type for each key
# (test_checks.py).
BAD_VALUES = [
    ("grid.normal_force=[1.0, 0.0]", "0.0", "greater than zero"),
    ("grid.hurst=-0.1", "-0.1", "between 0 and 1"),
    ("grid.spacing=0.005", "0.005", "at least 4 elements"),
    ("grid.roughness=0", "0.0", "greater than zero"),
    ("material.shear_modulus=-1e7", "-10000000.0", "greater than zero"),
    ("material.relaxation_time=inf", "inf", "finite number"),
    ("study.seed=-1", "-1", "whole number, at least 0"),
    ("study.seed=1.5", "1.5", "whole number"),
    ("study.seed=true", "True", "whole number"),
    ("study.realizations_per_block=16", "16", "at least 2 blocks"),
    ("scene.quantities=[]", "[]", "must be a list"),
    ('scene.quantities=["stedy"]', "'stedy'", "one of steady, jump, relaxation"),
    ("numerics.horizon=nan", "nan", "finite number"),
    ("numerics.accuracy=0", "0.0", "between 0.0001 and 0.3"),
    ("numerics.max_realizations=0", "0", "whole number"),
    ("compare.coarse.horizon=1000", "1000.0", "between 1 and 100"),
    ("cluster.jobs=0", "0", "at least 1"),
    ("cluster.patience=-1", "-1", "greater than zero"),
    ("cluster.prologue=[1]", "1", "string"),
    ("compare=1", "1", "must be a table"),
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
    assert round(small_study(f"grid.spacing={nearest}").surface.length / float(nearest)) == 333


@pytest.mark.parametrize(
    ("scales", "answer"),
    [
        ("", "--scale wide: the study knows none"),
        ("scales.wide = 3", "scales.wide = 3: must be a table"),
        ("scales = 3", "scales = 3: must be a table"),
    ],
)
def test_a_scale_that_is_none(scales, answer):
    assert complaint(text=f"{scales}\n{TEXT.partition('[scales')[0]}", scale="wide") == answer


@pytest.mark.parametrize(
    ("setting", "extreme"), [("grid.spacing", "5e-324"), ("surface.length", "1e306")]
)
def test_a_line_of_more_elements_than_any_float_is_refused(setting, extreme):
    assert "grid.spacing" in complaint(f"{setting}={extreme}")


def test_a_comparison_without_a_name_does_not_replace_the_study():
    answer = complaint(text=TEXT.replace("[compare.coarse]", '[compare.""]'))
    assert answer == 'compare."": name it by letters, digits and underscores'


@pytest.mark.parametrize("setting", ["grid.=3", "grid hurst=1"])
def test_setting_that_is_no_setting(setting):
    assert complaint(setting) == f"--set {setting}: use table.key=value"


def test_unknown_name_lists_the_known_studies():
    with pytest.raises(UserError, match=r"^study 'fig77': not among .*fig7"):
        find_study("fig77")


def test_a_missing_file_is_named_and_a_folder_is_no_study(tmp_path):
    (tmp_path / "folder.toml").mkdir()
    for name in ("nowhere.toml", "folder.toml"):
        with pytest.raises(UserError, match=rf"{name}': no such file$"):
            find_study(str(tmp_path / name))


def test_unreadable_file_is_named(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    path = write_study(tmp_path)
    monkeypatch.setattr("pathlib.Path.read_text", refuse)
    with pytest.raises(UserError, match=r"small\.toml: cannot be read.*Permission denied"):
        read_study(path)


@pytest.mark.parametrize("content", [b"\xff\xfe[study]", b"a = 1\na = 2", b"\x00"])
def test_what_is_not_toml_is_named(tmp_path, content):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(UserError, match=r"bad\.toml: cannot be read as TOML.*\Z"):
        read_study(str(path))


def test_a_list_without_brackets_is_shown_one(tmp_path):
    assert complaint("grid.hurst=0.3,0.5").endswith("; a list is [0.3, 0.5]")
    path = tmp_path / "bad.toml"
    path.write_text("[grid]\nhurst = 0.3, 0.5\n")
    with pytest.raises(UserError, match=r"cannot be read as TOML: .*; a list is \[0\.3, 0\.5\]$"):
        read_study(str(path))


def test_every_error_is_a_line_of_its_own_with_its_place(capsys, tmp_path):
    path = write_study(tmp_path, TEXT.replace("seed = 1", "sead = 1").replace("= 0.01", "= -1"))
    assert main(["plan", path]) == 2
    first, second = capsys.readouterr().err.splitlines()
    assert first.startswith("error: study.sead: unknown key; known are title, seed")
    assert first.endswith(f"did you mean seed? ({path}, line 4)")
    assert second == f"error: surface.length = -1: must be greater than zero ({path}, line 12)"


KNOWN = {**TABLES, "compare.coarse": COMPARE}


@pytest.mark.parametrize("key", [f"{table}.{key}" for table in KNOWN for key in KNOWN[table]])
def test_no_key_takes_a_date(key):
    assert complaint(f"{key}=1979-05-27").startswith(f"{key} = ")


@pytest.mark.parametrize("table", KNOWN)
def test_a_typo_in_a_key_is_answered_with_the_known_ones(table):
    said = complaint(f"{table}.hurts=1")
    end = "; did you mean hurst?" if "hurst" in KNOWN[table] else ""
    assert said == f"{table}.hurts: unknown key; known are {', '.join(KNOWN[table])}{end}"


def test_a_typo_in_a_table_is_answered_with_the_known_ones():
    assert complaint("gird.hurst=1").startswith("gird: unknown key; known are study, material, ")


REQUIRED = [
    *("study.realizations", "material.shear_modulus", "material.relaxation_time", "surface.length"),
    *(f"grid.{axis}" for axis in AXES),
]


@pytest.mark.parametrize("where", REQUIRED)
def test_missing_key_is_named(where):
    assert complaint(text=without(where)) == f"{where}: missing"


SEVERAL = """
[study]
sead = 1
realizations = 16

[material]
shear_modulus = -1e7

[scales.wide.grid]
normal_force = "much"

[scales.wide.numerics]
sceme = "exponential"

[scales.tall]
gird = {hurst = 0.3}

[compare.other]
scheme = "euler"
"""


def test_everything_is_said_at_once_in_the_order_of_the_file():
    with pytest.raises(UserErrors) as caught:
        small_study(text=SEVERAL)
    said = [str(error) for error in caught.value.errors]
    beginnings = [
        "study.sead: unknown key",
        "material.shear_modulus = -10000000.0: must be greater than zero",
        "compare.other.scheme = 'euler': must be one of",
        "scales.wide.grid.normal_force = 'much': must be a finite number",
        "scales.wide.numerics.sceme: unknown key",
        "scales.tall.gird: unknown key",
    ]
    assert len(said) == len(beginnings)
    for line, beginning in zip(said, beginnings, strict=True):
        assert line.startswith(beginning)
    assert str(caught.value).splitlines() == said
    assert [error.place.rpartition(" ")[2] for error in caught.value.errors] == [
        *("3)", "7)", "19)", "10)", "13)", "16)")
    ]


def test_all_missing_keys_of_a_table_are_said_at_once():
    lacking = TEXT.replace("hurst = [0.3, 0.7]\n", "").replace("roughness = 1e-5\n", "")
    with pytest.raises(UserErrors) as caught:
        small_study(text=lacking)
    assert [str(e) for e in caught.value.errors] == [
        "grid.hurst: missing",
        "grid.roughness: missing",
    ]


def test_what_values_come_to_together_is_left_to_the_scale_that_is_asked_for():
    large = TEXT + "[scales.fine.grid]\nspacing = 1e-12\n"
    assert small_study(text=large).name == "small"
    with pytest.raises(Exception, match=r"^grid.spacing = 1e-12: more than 1e\+08 elements"):
        small_study(text=large, scale="fine")
