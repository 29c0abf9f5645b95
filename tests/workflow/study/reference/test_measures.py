"""Every key of the measured studies of this program is described, as those of grids are."""

import shutil
import tomllib

import pytest

from elastomer_friction.workflow.study.reference.measures import described_measures
from elastomer_friction.workflow.study.scripts import OWN

MEASURES = described_measures()
KEYS = [(study, key) for study, keys in MEASURES.items() for key in keys]


def test_every_study_with_a_table_measure_is_described():
    tables = {
        path.parent.name: tomllib.loads(path.read_text(encoding="utf-8"))
        for path in OWN.glob("*/study.toml")
    }
    measured = {name: set(table["measure"]) for name, table in tables.items() if "measure" in table}
    assert measured
    assert {name: {key.name for key in keys} for name, keys in MEASURES.items()} == measured


@pytest.mark.parametrize(("study", "key"), KEYS, ids=[f"{s}.{k.name}" for s, k in KEYS])
def test_a_key_is_described_in_sentences(study, key):
    for text in (key.means, key.changes):
        assert text[0].isupper()
        assert text.endswith(".")
    assert key.values
    if key.values.startswith(("a number", "a whole number", "a list of numbers")):
        assert "oubled" in key.changes


def test_the_values_are_those_of_the_study_at_every_scale():
    (points,) = [key for study, key in KEYS if (study, key.name) == ("accuracy", "points")]
    assert points.default == "required; `17` in its study.toml, `3` at scale smoke"
    (workers,) = [key for study, key in KEYS if (study, key.name) == ("scaling", "workers")]
    assert "`[10, 100, 1000]` in its study.toml" in workers.default


def test_a_key_without_a_text_is_an_error(tmp_path):
    shutil.copytree(OWN / "stability", tmp_path / "other")
    script = tmp_path / "other" / "measure.py"
    text = script.read_text(encoding="utf-8")
    script.write_text(text + '\ndel TEXTS["steps"]\n', encoding="utf-8")
    with pytest.raises(KeyError, match="steps"):
        described_measures(tmp_path)
