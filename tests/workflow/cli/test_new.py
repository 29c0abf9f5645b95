"""The commands ``studies`` and ``new``: what can be named, and a study to start from."""

import json
import re

import pytest

from elastomer_friction.workflow.cli.commands import TEMPLATE
from elastomer_friction.workflow.study.read import known_studies, read_study
from elastomer_friction.workflow.study.tables import TABLES
from tests.support.commands import output, refusal


def test_studies_are_listed_with_their_titles(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in (("own", '[study]\ntitle = "Mine"'), ("broken", "="), ("nameless", "")):
        (tmp_path / "studies" / name).mkdir(parents=True)
        (tmp_path / "studies" / name / "study.toml").write_text(text)
    lines = dict(line.split(maxsplit=1) for line in output(capsys, "studies").splitlines())
    assert set(lines) == set(known_studies())
    assert lines["own"] == "Mine"
    assert lines["broken"] == lines["nameless"] == "(its study.toml cannot be read)"
    assert lines["fig7"] == read_study("fig7").title


def test_a_new_study_can_be_read_at_every_scale(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said = output(capsys, "new", "my-rubber")
    path = tmp_path / "studies" / "my_rubber" / "study.toml"
    assert (
        said == "studies/my_rubber/study.toml: edit it, then: python -m workflow plan my-rubber\n"
    )
    study, small = read_study("my-rubber"), read_study("my-rubber", "smoke")
    assert study.title.startswith("my-rubber: ")
    assert all(set(small.grid[axis]) <= set(study.grid[axis]) for axis in study.axes)
    written = path.read_text()
    assert "there is such a study already, " in refusal(capsys, "new", "my-rubber")
    assert path.read_text() == written


@pytest.mark.parametrize(
    ("name", "reason"), [("fig7", "there is such a study already"), ("../x", "name it by letters")]
)
def test_a_name_that_is_taken_or_none_is_refused(capsys, tmp_path, monkeypatch, name, reason):
    monkeypatch.chdir(tmp_path)
    assert reason in refusal(capsys, "new", name)
    assert not list(tmp_path.iterdir())


def test_values_said_to_be_usual_are_those_that_are_left_out(tmp_path):
    """Keys that are commented out: given as they stand there, the study is the same."""
    text = TEMPLATE.read_text(encoding="utf-8")
    given = re.sub(r"^# (\w+ = [^#\n]*)(#.*)?$", _usual, text, flags=re.MULTILINE)
    assert given.count("\n# ") < text.count("\n# ")
    paths = [tmp_path / name for name in ("left_out.toml", "given.toml")]
    for path, content in zip(paths, (text, given), strict=True):
        path.write_text(content)
    left_out, as_given = (read_study(str(path)) for path in paths)
    for name in ("grid", "scene", "variants", "materials", "surfaces"):
        assert getattr(left_out, name) == getattr(as_given, name), name
    keys = re.findall(r"^(?:# )?(\w+) = ", text, re.MULTILINE)
    assert set(keys) <= {key for table in TABLES.values() for key in table}


def _usual(found: re.Match) -> str:
    """Return a commented key as one that is given, but for those that the line excepts."""
    return found[0] if "none" in (found[2] or "") else found[1]


def test_the_schema_is_printed_as_json(capsys):
    schema = json.loads(output(capsys, "schema"))
    assert schema["properties"]["grid"]["properties"]["hurst"]["description"]
