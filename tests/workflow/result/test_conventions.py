"""Conformity of result files to the CF conventions, by an independent checker."""

import pytest

from elastomer_friction.workflow.result.netcdf import write_datasets
from tests.support import conventions


def test_a_result_keeps_the_cf_conventions(tmp_path, with_models):
    pytest.importorskip("compliance_checker")
    path = tmp_path / "small.nc"
    write_datasets(path, {"": with_models, "coarse": with_models, "fine": with_models})
    assert conventions.complaints(path) == []


def test_a_breach_of_the_conventions_is_noticed(tmp_path, with_models):
    pytest.importorskip("compliance_checker")
    with_models[["mu"]].to_netcdf(tmp_path / "bad.nc")  # not as we write it
    complaints = conventions.complaints(tmp_path / "bad.nc")
    assert "The variable sample failed because the datatype is int64" in complaints
