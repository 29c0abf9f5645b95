"""Refusals of a study: one line each with key, value and remedy."""

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.ground import UserError, UserErrors
from elastomer_friction.workflow.study.read import find_study, read_study
from elastomer_friction.workflow.study.tables import TABLES
from elastomer_friction.workflow.study.variants import COMPARE
from tests.support.small import TEXT, complaint, small_study, write_study


def test_the_nearest_spacing_proposed_is_accepted():
    message = complaint("grid.spacing=3e-5")
    nearest = message.partition("nearest: ")[2].partition(";")[0]
    assert round(small_study(f"grid.spacing={nearest}").surface.length / float(nearest)) == 333


@pytest.mark.parametrize(
    ("scales", "answer"),
    [
        ("", "--scale wide: must be a scale of the study: none"),
        ("scales.wide = 3", "scales.wide = 3: must be a table"),
        ("scales = 3", "scales = 3: must be a table"),
    ],
)
def test_an_unknown_scale_is_refused(scales, answer):
    assert complaint(text=f"{scales}\n{TEXT.partition('[scales')[0]}", scale="wide") == answer


def test_unknown_name_lists_the_known_studies():
    with pytest.raises(UserError, match=r"^study 'fig77': must be a study .* did you mean fig7"):
        find_study("fig77")


def test_a_missing_file_is_named_and_a_folder_is_no_study(tmp_path):
    (tmp_path / "folder.toml").mkdir()
    for name in ("nowhere.toml", "folder.toml"):
        with pytest.raises(UserError, match=rf"{name}': no such file$"):
            find_study(str(tmp_path / name))


HINT = r"; write a list as \[0\.3, 0\.5\]"


@pytest.mark.parametrize(
    ("content", "hint"),
    [
        (b"\xff\xfe[study]", ""),
        (b"a = 1\na = 2", ""),
        (b"\x00", ""),
        (b"[grid]\nhurst = 0.3, 0.5\n", HINT),
    ],
)
def test_a_file_that_is_not_toml_is_named_and_a_list_without_brackets_gets_a_hint(
    tmp_path, content, hint
):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(UserError, match=rf"bad\.toml: cannot be read as TOML: .*{hint}\Z"):
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
    message = complaint(f"{table}.hurts=1")
    end = "; did you mean hurst?" if "hurst" in KNOWN[table] else ""
    assert message == f"{table}.hurts: unknown key; known are {', '.join(KNOWN[table])}{end}"


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


def test_all_errors_are_reported_together_in_the_order_of_the_file():
    with pytest.raises(UserErrors) as caught:
        small_study(text=SEVERAL)
    messages = [str(error) for error in caught.value.errors]
    beginnings = [
        "study.sead: unknown key",
        "material.shear_modulus = -10000000.0: must be greater than zero",
        "compare.other.scheme = 'euler': must be one of",
        "scales.wide.grid.normal_force = 'much': must be a finite number",
        "scales.wide.numerics.sceme: unknown key",
        "scales.tall.gird: unknown key",
    ]
    assert len(messages) == len(beginnings)
    for line, beginning in zip(messages, beginnings, strict=True):
        assert line.startswith(beginning)
    assert str(caught.value).splitlines() == messages
    assert [error.place.rpartition(" ")[2] for error in caught.value.errors] == [
        *("3)", "7)", "19)", "10)", "13)", "16)")
    ]


def test_all_missing_keys_of_a_table_are_reported_together():
    lacking = TEXT.replace("hurst = [0.3, 0.7]\n", "").replace("roughness = 1e-5\n", "")
    with pytest.raises(UserErrors) as caught:
        small_study(text=lacking)
    assert [str(e) for e in caught.value.errors] == [
        "grid.hurst: missing",
        "grid.roughness: missing",
    ]


def test_combinations_of_values_are_checked_for_the_selected_scale_only():
    large = TEXT + "[scales.fine.grid]\nspacing = 1e-12\n"
    assert small_study(text=large).name == "small"
    with pytest.raises(Exception, match=r"^grid.spacing = 1e-12: makes more than 1e\+08 elements"):
        small_study(text=large, scale="fine")
