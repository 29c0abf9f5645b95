"""The commands as Python functions: the results and refusals of the command line."""

import json

import pytest
import xarray as xr

import elastomer_friction as ef
from elastomer_friction.workflow.cli import main
from tests.support.small import write_study


def test_a_study_is_planned_run_and_drawn_from_python(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    study = write_study(tmp_path)
    assert main(["plan", study, "--json"]) == 0
    planned = json.loads(json.dumps(ef.plan(study)))
    assert planned | {"settings": study} == json.loads(capsys.readouterr().out)
    with ef.run(study, settings=["study.realizations=8"]) as result:
        assert result.realizations.max() == 8
        assert "computing: 100%" in capsys.readouterr().err
        with ef.open("results/small.nc") as tree:
            xr.testing.assert_identical(result, tree.to_dataset())
        blocks = ef.block_means(study, settings=["study.realizations=8"])
        number = blocks.sizes["block"]
        assert number * blocks.attrs["realizations_per_block"] == 8
        for name in ("mu_1", "jump", "mu", "contact_fraction"):
            xr.testing.assert_allclose(blocks[name].mean("block"), result[name], rtol=1e-12)
        error = blocks.mu_1.std("block", ddof=1) / number**0.5
        xr.testing.assert_allclose(error, result.mu_1_error, rtol=1e-9)
    picture = ef.figure(study)
    assert picture.name == "small.png"
    assert picture.is_file()


def test_a_call_is_refused_as_the_command_is(tmp_path):
    with pytest.raises(ef.UserError, match="study 'nowhere': must be a study"):
        ef.run("nowhere")
    with pytest.raises(ef.UserError, match="not found; first run"):
        ef.figure(write_study(tmp_path), out=tmp_path)
    with pytest.raises(ef.UserError, match="not found; first run"):
        ef.block_means(write_study(tmp_path), out=tmp_path)
